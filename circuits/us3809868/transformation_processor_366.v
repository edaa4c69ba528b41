`default_nettype none

// Transformation processor 366 of US 3,809,868, FIG. 11: sends J, K, L, M and X0, Y0 through any of five
// transformations, and past the others, straight to the function generator.
//
//   j k l m --> 378 scaling --> 372 quarter turns --> 374 reflections --> 376 rotation --> 370
//   x0 y0   --> 380 offset  --> 370
//
// Switches 368 are one for each transformation, thrown by a bit of control 382: bit 0 lets 372 act, 1 374, 2 376, 3
// 378, 4 380. What is not switched in is passed by, its controls do not matter.
//
// From the text: 372 to 380 are "quarter turn rotations or reflections, generalized rotation, scaling, or offset", five
// numerals for five functions in that order. Each is the circuit of its figure: 372 and 374 FIG. 13, 376 FIG. 12, 378
// FIG. 14, 380 FIG. 15. A stroke is transformed by its coefficients alone, its points stay where they came from.
//
// Chosen, where the patent is silent:
// - the order, and that any of the five may act on one stroke;
// - 372 has the controls 450 (a quarter turn), 452 (a half), 454 (three quarters) of FIG. 13, 374 has 456 to 462.
//   Control 464 passes the stroke through either. Switched in, each needs just one of its own controls or 464,
//   otherwise `error`;
// - `start` (one tick, with j to m; the controls stay as they are until `finished`): `finished` is high for a tick when
//   the result stands, ten ticks later, and it stays until the next start. `error` goes with it, J to M are then 0;
// - 380 follows x0, y0 one tick later, by itself, as in FIG. 15: `error_380`.
module transformation_processor_366 (
    input wire clk,
    input wire start,
    input wire [4:0] control_382,
    input wire control_450,
    input wire control_452,
    input wire control_454,
    input wire control_456,
    input wire control_458,
    input wire control_460,
    input wire control_462,
    input wire control_464,
    input wire [15:0] angle_410,
    (* fraction = 12 *) input wire signed [15:0] factor_471,
    input wire signed [15:0] offset_x_488,
    input wire signed [15:0] offset_y_490,
    input wire signed [15:0] j,
    input wire signed [15:0] k,
    input wire signed [15:0] l,
    input wire signed [15:0] m,
    input wire signed [15:0] x0,
    input wire signed [15:0] y0,
    output wire signed [15:0] j_out,
    output wire signed [15:0] k_out,
    output wire signed [15:0] l_out,
    output wire signed [15:0] m_out,
    output wire signed [15:0] x0_out,
    output wire signed [15:0] y0_out,
    output wire finished,
    output wire error,
    output wire error_380
);
    // First 378 works, then 376 on what came of it, then the result is taken. Each is done when its `done` rises.
    wire done_378, done_376, before_378, before_376, new_378, new_376, scaled, rotated;
    delay_element #(.DELAY(1)) delay_378 (.clk(clk), .pulse_in(done_378), .pulse_out(before_378), .active());
    delay_element #(.DELAY(1)) delay_376 (.clk(clk), .pulse_in(done_376), .pulse_out(before_376), .active());
    not not_before_378 (new_378, before_378);
    not not_before_376 (new_376, before_376);
    and and_scaled (scaled, done_378, new_378);
    and and_rotated (rotated, done_376, new_376);

    // Switches 368: which transformation acts, which is passed by.
    wire past_372, past_374, past_376, past_378, past_380;
    not not_372 (past_372, control_382[0]);
    not not_374 (past_374, control_382[1]);
    not not_376 (past_376, control_382[2]);
    not not_378 (past_378, control_382[3]);
    not not_380 (past_380, control_382[4]);
    wire error_372, error_374, error_376, error_378, beyond_380;
    wire wrong_372, wrong_374, wrong_376, wrong_378, wrong;
    and and_wrong_372 (wrong_372, error_372, control_382[0]);
    and and_wrong_374 (wrong_374, error_374, control_382[1]);
    and and_wrong_376 (wrong_376, error_376, control_382[2]);
    and and_wrong_378 (wrong_378, error_378, control_382[3]);
    or or_wrong (wrong, wrong_372, wrong_374, wrong_376, wrong_378);

    // 378: scaling.
    wire signed [15:0] j_378, k_378, l_378, m_378;
    wire [63:0] after_378;
    fig14_scaling scaling_378 (
        .clk(clk), .start(start), .factor_471(factor_471), .j(j), .k(k), .l(l), .m(m),
        .j_out(j_378), .k_out(k_378), .l_out(l_378), .m_out(m_378), .done(done_378), .error(error_378)
    );
    multiplexer #(.WIDTH(64)) switch_scaling_368 (
        .a(past_378), .b(control_382[3]), .x1({j, k, l, m}), .x2({j_378, k_378, l_378, m_378}), .z(after_378)
    );

    // 372: quarter turns.
    wire signed [15:0] j_372, k_372, l_372, m_372;
    wire [63:0] after_372;
    fig13_quarter_turns quarter_turns_372 (
        .control_450(control_450), .control_452(control_452), .control_454(control_454), .control_456(1'b0),
        .control_458(1'b0), .control_460(1'b0), .control_462(1'b0), .control_464(control_464),
        .j(after_378[63:48]), .k(after_378[47:32]), .l(after_378[31:16]), .m(after_378[15:0]),
        .j_out(j_372), .k_out(k_372), .l_out(l_372), .m_out(m_372), .error(error_372)
    );
    multiplexer #(.WIDTH(64)) switch_quarter_turns_368 (
        .a(past_372), .b(control_382[0]), .x1(after_378), .x2({j_372, k_372, l_372, m_372}), .z(after_372)
    );

    // 374: reflections.
    wire signed [15:0] j_374, k_374, l_374, m_374;
    wire [63:0] after_374;
    fig13_quarter_turns reflections_374 (
        .control_450(1'b0), .control_452(1'b0), .control_454(1'b0), .control_456(control_456),
        .control_458(control_458), .control_460(control_460), .control_462(control_462), .control_464(control_464),
        .j(after_372[63:48]), .k(after_372[47:32]), .l(after_372[31:16]), .m(after_372[15:0]),
        .j_out(j_374), .k_out(k_374), .l_out(l_374), .m_out(m_374), .error(error_374)
    );
    multiplexer #(.WIDTH(64)) switch_reflections_368 (
        .a(past_374), .b(control_382[1]), .x1(after_372), .x2({j_374, k_374, l_374, m_374}), .z(after_374)
    );

    // 376: rotation.
    wire signed [15:0] j_376, k_376, l_376, m_376;
    wire [63:0] after_376;
    fig12_rotation rotation_376 (
        .clk(clk), .start(scaled), .angle_410(angle_410),
        .j(after_374[63:48]), .k(after_374[47:32]), .l(after_374[31:16]), .m(after_374[15:0]),
        .j_out(j_376), .k_out(k_376), .l_out(l_376), .m_out(m_376), .done(done_376), .error(error_376)
    );
    multiplexer #(.WIDTH(64)) switch_rotation_368 (
        .a(past_376), .b(control_382[2]), .x1(after_374), .x2({j_376, k_376, l_376, m_376}), .z(after_376)
    );

    // The result.
    converter_outputs outputs (
        .clk(clk), .load(start), .finish(rotated), .wrong(wrong),
        .j_word(after_376[63:48]), .k_word(after_376[47:32]), .l_word(after_376[31:16]), .m_word(after_376[15:0]),
        .j(j_out), .k(k_out), .l(l_out), .m(m_out), .error(error)
    );
    delay_element #(.DELAY(1)) delay_finished (.clk(clk), .pulse_in(rotated), .pulse_out(finished), .active());

    // 380: offset.
    wire signed [15:0] x0_380, y0_380;
    fig15_offset offset_380 (
        .clk(clk), .x0(x0), .y0(y0), .offset_x_488(offset_x_488), .offset_y_490(offset_y_490),
        .x0_out(x0_380), .y0_out(y0_380), .error(beyond_380)
    );
    multiplexer #(.WIDTH(32)) switch_offset_368 (
        .a(past_380), .b(control_382[4]), .x1({x0, y0}), .x2({x0_380, y0_380}), .z({x0_out, y0_out})
    );
    and and_error_380 (error_380, beyond_380, control_382[4]);
endmodule
