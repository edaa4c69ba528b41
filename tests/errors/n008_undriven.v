module n008_undriven (input wire a, output wire [7:0] b, output wire c);
    assign b[6:4] = {3{a}};
    assign b[1] = a;
    wire d;
endmodule
