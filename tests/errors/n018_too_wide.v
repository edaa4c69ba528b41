module n018_too_wide (input wire [64:0] a, output wire [3:0] b);
    wire [99:0] c;
    localparam WIDE = {33{2'b01}};
    assign b = 4'd0;
endmodule
