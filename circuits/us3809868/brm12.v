`default_nettype none

// A binary rate multiplier of 12 bits out of two SN7497 packages, wired as the data sheet says: the first package has
// the six heaviest rate bits; its enable output goes to enable and strobe of the second, whose Z goes to the
// unity/cascade input of the first. It does, tick for tick, what block binary_rate_multiplier does with WIDTH = 12.
module brm12 (
    input wire clk,
    input wire clear,        // asynchronous: also silences the outputs while it is high
    input wire pulse,
    input wire trailing,     // 1 in the last tick of a pulse
    input wire [11:0] rate,
    output wire out,
    output wire overflow
);
    wire enout_1, enout_2, z_2, overflow_pending;

    sn7497 package_1 (
        .clk(clk),
        .clock_low(pulse),
        .rising(trailing),
        .clr(clear),
        .strb(1'b0),
        .enin(1'b0),
        .unity(z_2),
        .rate(rate[11:6]),
        .y(out),
        .z(),
        .enout(enout_1)
    );
    sn7497 package_2 (
        .clk(clk),
        .clock_low(pulse),
        .rising(trailing),
        .clr(clear),
        .strb(enout_1),
        .enin(enout_1),
        .unity(1'b1),
        .rate(rate[5:0]),
        .y(),
        .z(z_2),
        .enout(enout_2)
    );
    not not_enout_2 (overflow_pending, enout_2);
    and and_overflow (overflow, overflow_pending, pulse);
endmodule
