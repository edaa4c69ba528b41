module n036_register_bits (input wire clk, input wire [63:0] a, output wire b);
    genvar i;
    for (i = 0; i < 500; i = i + 1) begin : turn
        bank of (.clk(clk), .a(a));
    end
    assign b = a[0];
endmodule

module bank (input wire clk, input wire [63:0] a);
    genvar i;
    for (i = 0; i < 200; i = i + 1) begin : turn
        register #(.WIDTH(64)) held (.clk(clk), .word(a), .enable(1'b1), .clear(1'b0));
    end
endmodule
