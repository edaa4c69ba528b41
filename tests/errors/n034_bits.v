module n034_bits (input wire [63:0] a, output wire [63:0] b);
    genvar i;
    for (i = 0; i < 65000; i = i + 1) begin : turn
        wire [63:0] x = a;
    end
    assign b = a;
endmodule
