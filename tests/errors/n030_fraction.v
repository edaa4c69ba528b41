module n030_fraction ((* fraction = 65 *) input wire [3:0] a, output wire b);
    (* fraction = -1, keep *) wire c = a[0];
    assign b = c;
endmodule
