module n020_constant (input wire [3:0] a, output wire b, c);
    localparam ZERO = 4 - 4;
    localparam QUOTIENT = 8 / ZERO;
    localparam LARGE = 1 << 40;
    localparam FROM_NET = a;
    genvar i;
    localparam FROM_GENVAR = i;
    assign b = a[a];
    assign c = {0{a[0]}};
endmodule
