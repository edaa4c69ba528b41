`default_nettype none

// Digital differential analyzer 338 of US 3,809,868, FIG. 10: vector acceleration from the pulses on lines 304, 306,
// 314, 316.
//
// For each axis two integrators stand in loops, each fed with its own overflow pulses backwards (a servo, the way in
// which a differential analyzer differentiates):
// - velocity: Y grows by the pulses of the lines and shrinks by the overflows, Y/2^BITS a tick. At rest both are equal:
//   Y is the pulses in 2^BITS ticks. It comes to rest in some 2^BITS ticks.
// - acceleration: what goes into the first Y is its change. A second loop of the same kind takes that, so that its Y is
//   the change of velocity in 2^BITS ticks.
// The length of the vector of both axes is the output.
//
// From the text: "a digital differential analyzer 338 of standard design", vector acceleration out. Chosen: the loops,
// their time, the same for both, and that x runs with the ticks (dx is always 1).
(* BITS_min = 2, BITS_max = 30 *)
module analyzer_338 #(
    parameter BITS = 10                             // its time is 2^BITS ticks; 2 to 30
) (
    input wire clk,
    input wire clear,                               // forgets what was
    input wire up_304,
    input wire down_306,
    input wire up_314,
    input wire down_316,
    output wire signed [BITS:0] velocity_x,         // pulses per 2^BITS ticks
    output wire signed [BITS:0] velocity_y,
    output wire signed [BITS:0] acceleration_x,     // pulses per 2^BITS ticks, per 2^BITS ticks
    output wire signed [BITS:0] acceleration_y,
    output wire [BITS+1:0] acceleration             // length of the vector
);
    // Increments: one for each pulse, at its trailing edge.
    wire x_up, x_down, y_up, y_down;
    trailing_edge #(.WIDTH(4)) edges (
        .clk(clk),
        .lines({down_316, up_314, down_306, up_304}),
        .strobes({y_down, y_up, x_down, x_up})
    );

    wire vx_up, vx_down, ax_up, ax_down;
    dda_integrator #(.WIDTH(BITS), .LINES(2)) integrator_velocity_x (
        .clk(clk),
        .clear(clear),
        .dx(1'b1),
        .up({vx_down, x_up}),
        .down({vx_up, x_down}),
        .y(velocity_x),
        .dz_up(vx_up),
        .dz_down(vx_down)
    );
    dda_integrator #(.WIDTH(BITS), .LINES(3)) integrator_acceleration_x (
        .clk(clk),
        .clear(clear),
        .dx(1'b1),
        .up({ax_down, vx_down, x_up}),
        .down({ax_up, vx_up, x_down}),
        .y(acceleration_x),
        .dz_up(ax_up),
        .dz_down(ax_down)
    );

    wire vy_up, vy_down, ay_up, ay_down;
    dda_integrator #(.WIDTH(BITS), .LINES(2)) integrator_velocity_y (
        .clk(clk),
        .clear(clear),
        .dx(1'b1),
        .up({vy_down, y_up}),
        .down({vy_up, y_down}),
        .y(velocity_y),
        .dz_up(vy_up),
        .dz_down(vy_down)
    );
    dda_integrator #(.WIDTH(BITS), .LINES(3)) integrator_acceleration_y (
        .clk(clk),
        .clear(clear),
        .dx(1'b1),
        .up({ay_down, vy_down, y_up}),
        .down({ay_up, vy_up, y_down}),
        .y(acceleration_y),
        .dz_up(ay_up),
        .dz_down(ay_down)
    );

    // Two fraction bits and a rounding, because the length is cut to a whole number.
    wire [BITS+3:0] quarters_of_length;
    wire [BITS+2:0] rounded;
    vector_magnitude #(.WIDTH(BITS + 3)) length (
        .x({acceleration_x, 2'b00}),
        .y({acceleration_y, 2'b00}),
        .magnitude(quarters_of_length)
    );
    rounder #(.A_WIDTH(BITS + 5), .FRACTION(2), .WIDTH(BITS + 3)) rounder_length (
        .clk(clk),
        .strobe(1'b1),
        .a({1'b0, quarters_of_length}),
        .rounded(rounded),
        .overflow()
    );
    assign acceleration = rounded[BITS+1:0];
endmodule
