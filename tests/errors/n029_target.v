module n029_target (input wire [3:0] a, output wire b);
    assign a[0] = 1'b1;
    assign {b, 1'b0} = a[1:0];
    not not_1 (a[1], a[2]);
endmodule
