module n035_ops (input wire clk, input wire a, output wire b);
    genvar i;
    for (i = 0; i < 60000; i = i + 1) begin : turn
        pulse_distributor #(.TAPS(64)) distributor (.clk(clk), .pulse_in(a));
    end
    assign b = a;
endmodule
