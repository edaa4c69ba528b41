// FIG. 4 of US 3,809,868 with FIG. 4A inside: the multiplying function generator, in its digital reading.
//
//   X(t) = J cos t - J + K sin t + X0      Y(t) = L cos t - L + M sin t + Y0
//
// An integrator (91), run up and down by switch 89, gives a triangle wave; straight pieces (93, 97) bend it and its
// complement (95) into |sin t| and |cos t|; polarity gates (99, 101) and summers (103, 105) make full waves of them;
// multipliers 80 to 86 and summers 88 and 90 form X(t) and Y(t).
//
// Errata: numeral 90 stands for the cosine generator (net cosine_90) and for a summer (summer_90, net y_90); 94 for the
// phase detector and, twice, for the time controller, which is 98; "t = 3/4" is 3 pi/2.
//
// Every other numeral of the two figures is an instance, but: generators 90 and 92 are all of FIG. 4A together and
// appear as their nets cosine_90 and sine_92; data converter 14 is outside, and so is display system 22, which gets x,
// y and mark.
//
// Chosen, where the patent is silent or analog:
//  - Words (sign included . fraction bits): the triangle runs from 0 to 2^28; sine and cosine 30.28, so that 1 is
//    exact; 80 to 86 46.28; 88 and 90 48.28; x and y rounded to 16 bits. At the quarter points sine and cosine are
//    exactly 0, 1 or -1, so the stroke ends exactly at X0 - J + K, Y0 - L + M (one quarter; likewise two to four).
//  - 80 to 90, 103 and 105 are clocked at every tick: x and y are three ticks behind sine and cosine. So `done` is the
//    stop pulse three ticks later, in the tick in which x and y show the end; the mark is lit from the tick in which
//    they show the beginning to that one. Then the integrator is discharged, and x, y are back at X0, Y0, blanked.
//  - J..M, X0, Y0 and `quarters` are taken in the tick of the start and kept in registers to the next.
//  - 102 sums up the deviation, in proportion to the rate itself, and regulates while 98 runs and the mark is due.
//    Reference: 2^26 units, a quarter of a count a tick. Rates: 1 is 2^-28 of a quarter a tick.
//  - `fast` = 1 throws switch 109 to reference 111: 2^20, a quarter in 256 ticks. That is more than the largest rate
//    of 102, 2^20 - 1, so a thrown switch is never slower, whatever the radius. Meanwhile 102 keeps its rate, and
//    for four ticks more, until the steps begun at full speed have left 88 and 90.
//  - `inhibit` = 1 blanks the mark in the same tick. Clipping (FIG. 16) judges x and y and gives both, `inhibit` to
//    100 and `fast` to 109: as x and y are registers, that closes no loop, and mark and point stay in step.
//  - `error`: `quarters` is 0 or more than 4, and the start was refused (`done` follows at once); or X or Y beyond 16
//    bits. It stays until the next start. A start while busy is ignored; `busy` has fallen when `done` comes, so the
//    next stroke may begin there.
`default_nettype none

(* PIECE_BITS_min = 0, PIECE_BITS_max = 7, VELOCITY_BITS_min = 4, VELOCITY_BITS_max = 40 *)
module fig04_function_generator #(
    parameter PIECE_BITS = 4,       // straight pieces a quarter: 2^PIECE_BITS
    parameter VELOCITY_BITS = 26    // reference of 102: 2^VELOCITY_BITS / 2^28 counts a tick
) (
    input wire clk,
    input wire start,
    input wire signed [15:0] j,
    input wire signed [15:0] k,
    input wire signed [15:0] l,
    input wire signed [15:0] m,
    input wire signed [15:0] x0,
    input wire signed [15:0] y0,
    input wire [2:0] quarters,
    input wire fast,                // throws switch 109
    input wire inhibit,             // blanks the mark
    output wire signed [15:0] x,
    output wire signed [15:0] y,
    output wire mark,
    output wire busy,
    output wire done,
    output wire error
);
    // Time controller 98, started from outside, stopped by the strobe that switch 96 selects.
    wire begun;
    wire idle;
    wire selected;
    wire out_of_range;
    wire good_quarters;
    wire running;
    wire stop;
    not not_quarters (good_quarters, out_of_range);
    and and_start (begun, start, idle, good_quarters);
    trigger time_controller_98 (.clk(clk), .set(begun), .reset(stop), .q(running));
    and and_stop (stop, selected, running);
    wire ended;
    trigger busy_trigger (.clk(clk), .set(begun), .reset(ended), .q(busy), .q_inverse(idle));

    // The data of the stroke.
    wire signed [15:0] j_held, k_held, l_held, m_held, x0_held, y0_held;
    register #(.WIDTH(16)) register_j (.clk(clk), .word(j), .enable(begun), .clear(1'b0), .q(j_held));
    register #(.WIDTH(16)) register_k (.clk(clk), .word(k), .enable(begun), .clear(1'b0), .q(k_held));
    register #(.WIDTH(16)) register_l (.clk(clk), .word(l), .enable(begun), .clear(1'b0), .q(l_held));
    register #(.WIDTH(16)) register_m (.clk(clk), .word(m), .enable(begun), .clear(1'b0), .q(m_held));
    register #(.WIDTH(16)) register_x0 (.clk(clk), .word(x0), .enable(begun), .clear(1'b0), .q(x0_held));
    register #(.WIDTH(16)) register_y0 (.clk(clk), .word(y0), .enable(begun), .clear(1'b0), .q(y0_held));

    // FIG. 4A: the rate.
    wire [19:0] rate_102;
    wire signed [21:0] rate_111;
    wire [21:0] rate_109;
    wire compensated;
    wire signed [22:0] plus_107;
    wire signed [22:0] minus_107;
    wire signed [22:0] rate_89;
    wire at_lower;
    wire at_upper;
    reference #(.WIDTH(22), .VALUE(1048576)) reference_111 (.value(rate_111));
    not not_fast (compensated, fast);
    multiplexer #(.WIDTH(22)) switch_109 (
        .a(compensated), .b(fast), .x1({2'b00, rate_102}), .x2(rate_111), .z(rate_109)
    );
    bipolar_gate #(.WIDTH(22)) gate_107 (.enable(running), .rate(rate_109), .plus(plus_107), .minus(minus_107));
    bound_switch #(.WIDTH(23)) switch_89 (
        .clk(clk), .plus(plus_107), .minus(minus_107), .at_lower(at_lower), .at_upper(at_upper), .reset(stop),
        .rate(rate_89)
    );

    // FIG. 4A: the triangle and the waves.
    wire [28:0] triangle_91;
    wire [28:0] rest_95;
    wire [28:0] sine_93;
    wire [28:0] cosine_97;
    integrator #(.BITS(28), .RATE_WIDTH(23)) integrator_91 (
        .clk(clk), .rate(rate_89), .reset(stop), .level(triangle_91), .at_lower(at_lower), .at_upper(at_upper)
    );
    limit_inverter #(.BITS(28)) inverter_95 (.level(triangle_91), .rest(rest_95));
    diode_approximator #(.BITS(28), .PIECE_BITS(PIECE_BITS)) approximator_93 (.level(triangle_91), .value(sine_93));
    diode_approximator #(.BITS(28), .PIECE_BITS(PIECE_BITS)) approximator_97 (.level(rest_95), .value(cosine_97));

    wire signed [29:0] direct_99;
    wire signed [29:0] inverted_99;
    wire signed [29:0] direct_101;
    wire signed [29:0] inverted_101;
    (* fraction = 28 *) wire signed [29:0] sine_92;
    (* fraction = 28 *) wire signed [29:0] cosine_90;
    polarity_gate #(.WIDTH(29)) gate_99 (
        .clk(clk), .magnitude(sine_93), .at_zero(at_lower), .reset(stop), .direct(direct_99), .inverted(inverted_99)
    );
    polarity_gate #(.WIDTH(29)) gate_101 (
        .clk(clk), .magnitude(cosine_97), .at_zero(at_upper), .reset(stop), .direct(direct_101), .inverted(inverted_101)
    );
    summer #(.A_WIDTH(30), .B_WIDTH(30), .WIDTH(30)) summer_103 (
        .clk(clk), .strobe(1'b1), .a(direct_99), .b(inverted_99), .sum(sine_92)
    );
    summer #(.A_WIDTH(30), .B_WIDTH(30), .WIDTH(30)) summer_105 (
        .clk(clk), .strobe(1'b1), .a(direct_101), .b(inverted_101), .sum(cosine_90)
    );

    // FIG. 4: the products and their sums.
    (* fraction = 28 *) wire signed [45:0] product_80;
    (* fraction = 28 *) wire signed [45:0] product_82;
    (* fraction = 28 *) wire signed [45:0] product_84;
    (* fraction = 28 *) wire signed [45:0] product_86;
    (* fraction = 28 *) wire signed [47:0] x_88;
    (* fraction = 28 *) wire signed [47:0] y_90;
    multiplier #(.A_WIDTH(16), .B_WIDTH(30), .WIDTH(46)) multiplier_80 (
        .clk(clk), .strobe(1'b1), .a(j_held), .b(cosine_90), .product(product_80)
    );
    multiplier #(.A_WIDTH(16), .B_WIDTH(30), .WIDTH(46)) multiplier_82 (
        .clk(clk), .strobe(1'b1), .a(k_held), .b(sine_92), .product(product_82)
    );
    multiplier #(.A_WIDTH(16), .B_WIDTH(30), .WIDTH(46)) multiplier_84 (
        .clk(clk), .strobe(1'b1), .a(m_held), .b(sine_92), .product(product_84)
    );
    multiplier #(.A_WIDTH(16), .B_WIDTH(30), .WIDTH(46)) multiplier_86 (
        .clk(clk), .strobe(1'b1), .a(l_held), .b(cosine_90), .product(product_86)
    );
    // J and L go to the inverting inputs as late as the products come out: x and y do not jump when they change.
    wire signed [15:0] j_late, l_late;
    register #(.WIDTH(16)) late_j (.clk(clk), .word(j_held), .enable(1'b1), .clear(1'b0), .q(j_late));
    register #(.WIDTH(16)) late_l (.clk(clk), .word(l_held), .enable(1'b1), .clear(1'b0), .q(l_late));
    summer_4 #(.A_WIDTH(46), .B_WIDTH(46), .C_WIDTH(44), .D_WIDTH(44), .WIDTH(48), .NEGATIVE(4'b0100)) summer_88 (
        .clk(clk), .strobe(1'b1), .a(product_80), .b(product_82), .c({j_late, 28'd0}), .d({x0_held, 28'd0}), .sum(x_88)
    );
    summer_4 #(.A_WIDTH(46), .B_WIDTH(46), .C_WIDTH(44), .D_WIDTH(44), .WIDTH(48), .NEGATIVE(4'b0100)) summer_90 (
        .clk(clk), .strobe(1'b1), .a(product_86), .b(product_84), .c({l_late, 28'd0}), .d({y0_held, 28'd0}), .sum(y_90)
    );
    wire overflow_x;
    wire overflow_y;
    rounder #(.A_WIDTH(48), .FRACTION(28), .WIDTH(16)) rounder_88 (
        .clk(clk), .strobe(1'b1), .a(x_88), .rounded(x), .overflow(overflow_x)
    );
    rounder #(.A_WIDTH(48), .FRACTION(28), .WIDTH(16)) rounder_90 (
        .clk(clk), .strobe(1'b1), .a(y_90), .rounded(y), .overflow(overflow_y)
    );

    // The quarter points: phase detector 94, logic switch 96.
    wire [3:0] strobes_94;
    phase_detector #(.WIDTH(30)) phase_detector_94 (
        .clk(clk), .sine(sine_92), .cosine(cosine_90), .strobes(strobes_94)
    );
    strobe_switch switch_96 (
        .clk(clk), .strobes(strobes_94), .load(begun), .quarters(quarters), .strobe(selected),
        .out_of_range(out_of_range)
    );

    // Mark inhibit 100, as late as x and y are.
    wire mark_on;
    wire drawing;
    wire not_inhibited;
    delay_element #(.DELAY(4)) delay_start (.clk(clk), .pulse_in(begun), .pulse_out(mark_on));
    delay_element #(.DELAY(2)) delay_stop (.clk(clk), .pulse_in(stop), .pulse_out(ended));
    wire refused;
    wire finished;
    or or_finished (finished, ended, refused);
    delay_element #(.DELAY(1)) delay_done (.clk(clk), .pulse_in(finished), .pulse_out(done));
    trigger mark_inhibit_100 (.clk(clk), .set(mark_on), .reset(done), .q(drawing));
    not not_inhibit (not_inhibited, inhibit);
    and mark_gate_100 (mark, drawing, not_inhibited);

    // Velocity compensator 102 sees X(t) and Y(t) before they are rounded. A rate is in their difference four ticks
    // later. It starts over when 98 is reset, so that a stroke that begins with `done` finds it at its start.
    wire regulate_102;
    and and_regulate_102 (regulate_102, running, drawing);
    wire fast_before;
    wire hold_102;
    delay_element #(.DELAY(4)) delay_fast (.clk(clk), .pulse_in(fast), .active(fast_before));
    or or_hold (hold_102, fast, fast_before);
    velocity_compensator #(.WIDTH(48), .VELOCITY_BITS(VELOCITY_BITS), .RATE_BITS(20)) velocity_compensator_102 (
        .clk(clk), .enable(regulate_102), .hold(hold_102), .x(x_88), .y(y_90), .rate(rate_102)
    );

    // Errors.
    wire beyond;
    wire beyond_now;
    wire wrong;
    and and_refused (refused, start, idle, out_of_range);
    or or_beyond (beyond, overflow_x, overflow_y);
    and and_beyond (beyond_now, beyond, drawing);
    or or_wrong (wrong, refused, beyond_now);
    trigger error_trigger (.clk(clk), .set(wrong), .reset(begun), .q(error));
endmodule
