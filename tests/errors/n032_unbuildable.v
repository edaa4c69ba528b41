module n032_unbuildable (input wire clk, input wire enable, input wire [47:0] x, output wire [23:0] rate);
    velocity_compensator #(.RATE_BITS(24), .VELOCITY_BITS(40)) regulator (
        .clk(clk), .enable(enable), .hold(1'b0), .x(x), .y(x), .rate(rate)
    );
endmodule
