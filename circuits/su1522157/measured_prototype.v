`default_nettype none

// The prototype of SU 1522157 with a meter behind it, so that a frame is judged where it is drawn: no step has to leave
// the simulator. Ports and parameters are those of the prototype, with what the meter shows besides. The major axis
// is called so whichever it is: a whole step is one along it, be it on 36 or on 37.
(* WIDTH_min = 1, WIDTH_max = 48, CLOCK_PERIOD_min = 1, CLOCK_PERIOD_max = 65536,
   TAP_SPACING_min = 1, TAP_SPACING_max = 64,
   DELAY_22_min = 1, DELAY_22_max = 1024, MINUS_ZERO_min = 0, MINUS_ZERO_max = 1 *)
module measured_prototype #(
    parameter WIDTH = 12,
    parameter CLOCK_PERIOD = 4,
    parameter TAP_SPACING = 2,
    parameter DELAY_22 = 2,
    parameter MINUS_ZERO = 0
) (
    input wire clk,
    input wire [WIDTH-1:0] major_32,
    input wire start_33,
    input wire [WIDTH-1:0] minor_34,
    input wire x_is_major_35,
    output wire step_x_36,
    output wire step_y_37,
    output wire step_xy_38,
    output wire busy,
    output wire [WIDTH+2:0] greatest,          // greatest |p minor - q major| of a node (p, q) in quarters
    output wire signed [WIDTH+3:0] left_major, // quarters left to go
    output wire signed [WIDTH+3:0] left_minor,
    output wire [WIDTH:0] longest_run          // most equal steps in a row
);
    prototype #(
        .WIDTH(WIDTH),
        .CLOCK_PERIOD(CLOCK_PERIOD),
        .TAP_SPACING(TAP_SPACING),
        .DELAY_22(DELAY_22),
        .MINUS_ZERO(MINUS_ZERO)
    ) measured (
        .clk(clk),
        .major_32(major_32),
        .start_33(start_33),
        .minor_34(minor_34),
        .x_is_major_35(x_is_major_35),
        .step_x_36(step_x_36),
        .step_y_37(step_y_37),
        .step_xy_38(step_xy_38),
        .busy(busy)
    );

    wire whole;
    or or_whole (whole, step_x_36, step_y_37);
    deviation_meter #(.WIDTH(WIDTH), .COMBINED(4)) meter (
        .clk(clk),
        .start(start_33),
        .major(major_32),
        .minor(minor_34),
        .whole(whole),
        .combined(step_xy_38),
        .greatest(greatest),
        .left_major(left_major),
        .left_minor(left_minor),
        .longest_run(longest_run)
    );
endmodule
