`default_nettype none

// A binary rate multiplier of 18 bits out of three SN7497 packages. Enable outputs are chained as in brm12; a package
// has only one unity/cascade input, so the three Z outputs meet in a NAND gate outside. It does, tick for tick, what
// block binary_rate_multiplier does with WIDTH = 18.
module brm18 (
    input wire clk,
    input wire clear,        // asynchronous: also silences the outputs while it is high
    input wire pulse,
    input wire trailing,     // 1 in the last tick of a pulse
    input wire [17:0] rate,
    output wire out,
    output wire overflow
);
    wire enout_1, enout_2, enout_3, z_1, z_2, z_3, overflow_pending;

    sn7497 package_1 (
        .clk(clk),
        .clock_low(pulse),
        .rising(trailing),
        .clr(clear),
        .strb(1'b0),
        .enin(1'b0),
        .unity(1'b1),
        .rate(rate[17:12]),
        .y(),
        .z(z_1),
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
        .rate(rate[11:6]),
        .y(),
        .z(z_2),
        .enout(enout_2)
    );
    sn7497 package_3 (
        .clk(clk),
        .clock_low(pulse),
        .rising(trailing),
        .clr(clear),
        .strb(enout_2),
        .enin(enout_2),
        .unity(1'b1),
        .rate(rate[5:0]),
        .y(),
        .z(z_3),
        .enout(enout_3)
    );
    nand nand_out (out, z_1, z_2, z_3);
    not not_enout_3 (overflow_pending, enout_3);
    and and_overflow (overflow, overflow_pending, pulse);
endmodule
