`default_nettype none

// A plotter with the linear interpolator of SU 1522157 A1: signed projections in, motors out.
//
// The patent claims the interpolator alone; what surrounds it here is chosen. It says that the signs of the projections
// are applied outside, and that the path may be turned by multiples of 45 degrees without a new computation, by the
// output commutator, which exchanges the roles of steps. That is what commutator_45 does, and the price shows: a whole
// step is 1 long and a combined one 0.75 * sqrt(2) = 1.0607, so that an odd number of eighths of a turn stretches what
// were whole steps by 6.07 % and shrinks what were combined ones by 5.72 %.
//
// Counters x and y hold the drawn position in quarters of a step, in which both kinds of steps are whole numbers. A motor
// step is a quarter, too: each step becomes a burst of four or three pulses, for which generator 15 has to leave 8 ticks.
//
// - A start with dx or dy = -2^WIDTH, which has no magnitude of WIDTH bits, is refused: `error` goes high until the next
//   start that is accepted, and `done` follows at once.
// - A start while `busy` is high disturbs the frame under way.
// - A frame of no length (dx = dy = 0) draws one whole step along Y: the spurious step of the interpolator.
// - Frames follow each other from where the last one ended, which is up to a quarter of a step off its end point on either
//   axis; nothing here carries that residue over.
// - The counters wrap round at 2^(WIDTH+5) whole steps, either way.
(* WIDTH_min = 1, WIDTH_max = 24, CLOCK_PERIOD_min = 8, CLOCK_PERIOD_max = 65536,
   TAP_SPACING_min = 1, TAP_SPACING_max = 64, DELAY_13_min = 1, DELAY_13_max = 1024,
   DELAY_22_min = 1, DELAY_22_max = 1024, MINUS_ZERO_min = 0, MINUS_ZERO_max = 1 *)
module plotter #(
    parameter WIDTH = 12,       // bits of a projection without its sign
    parameter CLOCK_PERIOD = 8, // ticks from one step to the next, at least 8
    parameter TAP_SPACING = 2,  // as in the interpolator
    parameter DELAY_13 = 1,
    parameter DELAY_22 = 2,
    parameter MINUS_ZERO = 0
) (
    input wire clk,
    input wire start,                               // one tick, with the three inputs below
    input wire signed [WIDTH:0] dx,                 // the segment, in whole steps
    input wire signed [WIDTH:0] dy,
    input wire [2:0] turn_45,                       // eighths of a turn, counter-clockwise
    (* fraction = 2 *) output wire signed [WIDTH+7:0] x, // where the pen is
    (* fraction = 2 *) output wire signed [WIDTH+7:0] y,
    output wire step_x_36,                          // the steps as the interpolator gives them
    output wire step_y_37,
    output wire step_xy_38,
    output wire [7:0] steps_45,                     // the steps as they are drawn, one line for each eighth of a turn
    output wire signed [WIDTH+7:0] motor_x,         // where the motors stand, in quarters
    output wire signed [WIDTH+7:0] motor_y,
    output wire busy,                               // until all pulses are past
    output wire done,                               // one tick after the end, or after a refused start
    output wire error                               // the last start was refused
);
    localparam POSITION = WIDTH + 8;

    // The projections without their signs, in order of size: inputs 32, 34 and 35.
    wire [WIDTH-1:0] magnitude_x, magnitude_y, major_32, minor_34;
    wire minus_x, minus_y, too_large_x, too_large_y, x_is_major_35;
    absolute_value #(.WIDTH(WIDTH)) absolute_x (
        .word(dx),
        .magnitude(magnitude_x),
        .is_negative(minus_x),
        .too_large(too_large_x)
    );
    absolute_value #(.WIDTH(WIDTH)) absolute_y (
        .word(dy),
        .magnitude(magnitude_y),
        .is_negative(minus_y),
        .too_large(too_large_y)
    );
    order #(.WIDTH(WIDTH)) order_35 (
        .a(magnitude_x),
        .b(magnitude_y),
        .greater(major_32),
        .lesser(minor_34),
        .a_is_greater(x_is_major_35)
    );

    // Start pulse 33, unless the segment is too large.
    wire too_large, fits, start_33, refused;
    or or_too_large (too_large, too_large_x, too_large_y);
    not not_too_large (fits, too_large);
    and and_33 (start_33, start, fits);
    and and_refused (refused, start, too_large);
    trigger trigger_error (.clk(clk), .set(refused), .reset(start_33), .q(error));

    wire interpolates;
    interpolator #(
        .WIDTH(WIDTH),
        .CLOCK_PERIOD(CLOCK_PERIOD),
        .TAP_SPACING(TAP_SPACING),
        .DELAY_13(DELAY_13),
        .DELAY_22(DELAY_22),
        .MINUS_ZERO(MINUS_ZERO)
    ) interpolator_1 (
        .clk(clk),
        .major_32(major_32),
        .start_33(start_33),
        .minor_34(minor_34),
        .x_is_major_35(x_is_major_35),
        .step_x_36(step_x_36),
        .step_y_37(step_y_37),
        .step_xy_38(step_xy_38),
        .busy(interpolates)
    );

    // The octant, held for the frame.
    wire minus_x_33, minus_y_33;
    wire [2:0] turn_33;
    register #(.WIDTH(5)) octant_33 (
        .clk(clk),
        .word({turn_45, minus_y, minus_x}),
        .enable(start_33),
        .clear(1'b0),
        .q({turn_33, minus_y_33, minus_x_33})
    );
    octant_commutator commutator_45 (
        .step_x(step_x_36),
        .step_y(step_y_37),
        .step_xy(step_xy_38),
        .minus_x(minus_x_33),
        .minus_y(minus_y_33),
        .turn(turn_33),
        .lines(steps_45)
    );

    // Eight lines to two axes: bit 0 of each pair a whole step, bit 1 a combined one.
    wire [1:0] right, left, up, down;
    assign right[0] = steps_45[0];
    assign up[0] = steps_45[2];
    assign left[0] = steps_45[4];
    assign down[0] = steps_45[6];
    or or_right (right[1], steps_45[1], steps_45[7]);
    or or_up (up[1], steps_45[1], steps_45[3]);
    or or_left (left[1], steps_45[3], steps_45[5]);
    or or_down (down[1], steps_45[5], steps_45[7]);

    position_counter #(.WIDTH(POSITION)) counter_x (.clk(clk), .forward(right), .back(left), .position(x));
    position_counter #(.WIDTH(POSITION)) counter_y (.clk(clk), .forward(up), .back(down), .position(y));

    wire pulse_right, pulse_left, pulse_up, pulse_down, bursts_x, bursts_y;
    step_burst burst_x (.clk(clk), .forward(right), .back(left), .up(pulse_right), .down(pulse_left), .active(bursts_x));
    step_burst burst_y (.clk(clk), .forward(up), .back(down), .up(pulse_up), .down(pulse_down), .active(bursts_y));
    stepping_motor #(.WIDTH(POSITION)) motor_of_x (
        .clk(clk),
        .preset(1'b0),
        .preset_value({POSITION{1'b0}}),
        .up(pulse_right),
        .down(pulse_left),
        .position(motor_x)
    );
    stepping_motor #(.WIDTH(POSITION)) motor_of_y (
        .clk(clk),
        .preset(1'b0),
        .preset_value({POSITION{1'b0}}),
        .up(pulse_up),
        .down(pulse_down),
        .position(motor_y)
    );

    or or_busy (busy, interpolates, bursts_x, bursts_y);
    wire ended, refused_before;
    trailing_edge #(.WIDTH(1)) end_of_frame (.clk(clk), .lines(busy), .strobes(ended));
    register #(.WIDTH(1)) register_refused (
        .clk(clk), .word(refused), .enable(1'b1), .clear(1'b0), .q(refused_before)
    );
    or or_done (done, ended, refused_before);
endmodule
