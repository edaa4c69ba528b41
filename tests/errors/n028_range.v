module n028_range #(parameter WIDTH = 0) (input wire [0:7] a, output wire [3:0] b, input wire [WIDTH-1:0] c);
    wire [7:0] d = 8'd0;
    assign b = d[0:3];
endmodule
