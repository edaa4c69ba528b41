// FIG. 4 of US 3,809,868 with FIG. 4A inside: the multiplying function generator, in its digital reading.
//
//   X(t) = J cos t - J + K sin t + X0      Y(t) = L cos t - L + M sin t + Y0
//
// An integrator (91), run up and down by switch 89, gives a triangle wave; straight pieces (93, 97) bend it and its
// complement (95) into |sin t| and |cos t|; polarity gates (99, 101) and summers (103, 105) make full waves of them;
// multipliers 80 to 86 and summers 88 and 90 form X(t) and Y(t).
//
// Errata: numeral 90 stands for the cosine generator and for a summer (summer_90; the cosine comes out of 105); 94 for
// the phase detector and, twice, for the time controller, which is 98; "t = 3/4" is 3 pi/2.
//
// Chosen, where the patent is silent or analog:
//  - Words (sign included . fraction bits): the triangle runs from 0 to 2^28; sine and cosine 30.28, so that 1 is
//    exact; 80 to 86 46.28; 88 and 90 48.28; x and y rounded to 16 bits. At the quarter points sine and cosine are
//    exactly 0, 1 or -1, so the stroke ends exactly at X0 - J + K, Y0 - L + M (one quarter; likewise two to four).
//  - 80 to 90, 103 and 105 are clocked at every tick: x and y are three ticks behind sine and cosine. So `done` is the
//    stop pulse three ticks later, in the tick in which x and y show the end; the mark is lit from the tick in which
//    they show the beginning to that one. Then the integrator is discharged, and x, y are back at X0, Y0, blanked.
//  - J..M, X0, Y0 and `quarters` are not stored: they have to stay until `done`.
//  - 102 sums up the deviation, in proportion to the rate itself, and regulates while the mark is lit. Reference: 2^26
//    units, a quarter of a count a tick. Rates: 1 is 2^-28 of a quarter a tick.
//  - Reference 111, for `fast` = 1 (switch 109 thrown): 2^18, a quarter in 1024 ticks.
//  - `error`: `quarters` is 0 or more than 4, and the start was refused; or X or Y beyond 16 bits. It stays until the
//    next start. A start while busy is ignored; `busy` has fallen when `done` comes, so the next stroke may begin there.
`default_nettype none

module fig04_function_generator #(
    parameter PIECE_BITS = 4,       // straight pieces a quarter: 2^PIECE_BITS
    parameter VELOCITY_BITS = 26,   // reference of 102: 2^VELOCITY_BITS / 2^28 counts a tick
    parameter FAST_RATE = 262144    // reference 111, below 2^19
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
    input wire fast,
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

    // FIG. 4A: the rate.
    wire [19:0] rate_102;
    wire [19:0] rate_111;
    wire [19:0] rate_109;
    wire compensated;
    wire signed [20:0] plus_107;
    wire signed [20:0] minus_107;
    wire signed [20:0] rate_89;
    wire at_lower;
    wire at_upper;
    reference #(.WIDTH(20), .VALUE(FAST_RATE)) reference_111 (.value(rate_111));
    not not_fast (compensated, fast);
    multiplexer #(.WIDTH(20)) switch_109 (.a(compensated), .b(fast), .x1(rate_102), .x2(rate_111), .z(rate_109));
    bipolar_gate #(.WIDTH(20)) gate_107 (.enable(running), .rate(rate_109), .plus(plus_107), .minus(minus_107));
    bound_switch #(.WIDTH(21)) switch_89 (
        .clk(clk), .plus(plus_107), .minus(minus_107), .at_lower(at_lower), .at_upper(at_upper), .reset(stop),
        .rate(rate_89)
    );

    // FIG. 4A: the triangle and the waves.
    wire [28:0] triangle_91;
    wire [28:0] rest_95;
    wire [28:0] sine_93;
    wire [28:0] cosine_97;
    integrator #(.BITS(28), .RATE_WIDTH(21)) integrator_91 (
        .clk(clk), .rate(rate_89), .reset(stop), .level(triangle_91), .at_lower(at_lower), .at_upper(at_upper)
    );
    limit_inverter #(.BITS(28)) inverter_95 (.level(triangle_91), .rest(rest_95));
    diode_approximator #(.BITS(28), .PIECE_BITS(PIECE_BITS)) approximator_93 (.level(triangle_91), .value(sine_93));
    diode_approximator #(.BITS(28), .PIECE_BITS(PIECE_BITS)) approximator_97 (.level(rest_95), .value(cosine_97));

    wire signed [29:0] direct_99;
    wire signed [29:0] inverted_99;
    wire signed [29:0] direct_101;
    wire signed [29:0] inverted_101;
    (* fraction = 28 *) wire signed [29:0] sine_103;
    (* fraction = 28 *) wire signed [29:0] cosine_105;
    polarity_gate #(.WIDTH(29)) gate_99 (
        .clk(clk), .magnitude(sine_93), .at_zero(at_lower), .reset(stop), .direct(direct_99), .inverted(inverted_99)
    );
    polarity_gate #(.WIDTH(29)) gate_101 (
        .clk(clk), .magnitude(cosine_97), .at_zero(at_upper), .reset(stop), .direct(direct_101), .inverted(inverted_101)
    );
    summer #(.A_WIDTH(30), .B_WIDTH(30), .WIDTH(30)) summer_103 (
        .clk(clk), .strobe(1'b1), .a(direct_99), .b(inverted_99), .sum(sine_103)
    );
    summer #(.A_WIDTH(30), .B_WIDTH(30), .WIDTH(30)) summer_105 (
        .clk(clk), .strobe(1'b1), .a(direct_101), .b(inverted_101), .sum(cosine_105)
    );

    // FIG. 4: the products and their sums.
    (* fraction = 28 *) wire signed [45:0] product_80;
    (* fraction = 28 *) wire signed [45:0] product_82;
    (* fraction = 28 *) wire signed [45:0] product_84;
    (* fraction = 28 *) wire signed [45:0] product_86;
    (* fraction = 28 *) wire signed [47:0] x_88;
    (* fraction = 28 *) wire signed [47:0] y_90;
    multiplier #(.A_WIDTH(16), .B_WIDTH(30), .WIDTH(46)) multiplier_80 (
        .clk(clk), .strobe(1'b1), .a(j), .b(cosine_105), .product(product_80)
    );
    multiplier #(.A_WIDTH(16), .B_WIDTH(30), .WIDTH(46)) multiplier_82 (
        .clk(clk), .strobe(1'b1), .a(k), .b(sine_103), .product(product_82)
    );
    multiplier #(.A_WIDTH(16), .B_WIDTH(30), .WIDTH(46)) multiplier_84 (
        .clk(clk), .strobe(1'b1), .a(m), .b(sine_103), .product(product_84)
    );
    multiplier #(.A_WIDTH(16), .B_WIDTH(30), .WIDTH(46)) multiplier_86 (
        .clk(clk), .strobe(1'b1), .a(l), .b(cosine_105), .product(product_86)
    );
    summer_4 #(.A_WIDTH(46), .B_WIDTH(46), .C_WIDTH(44), .D_WIDTH(44), .WIDTH(48), .NEGATIVE(4'b0100)) summer_88 (
        .clk(clk), .strobe(1'b1), .a(product_80), .b(product_82), .c({j, 28'd0}), .d({x0, 28'd0}), .sum(x_88)
    );
    summer_4 #(.A_WIDTH(46), .B_WIDTH(46), .C_WIDTH(44), .D_WIDTH(44), .WIDTH(48), .NEGATIVE(4'b0100)) summer_90 (
        .clk(clk), .strobe(1'b1), .a(product_86), .b(product_84), .c({l, 28'd0}), .d({y0, 28'd0}), .sum(y_90)
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
        .clk(clk), .sine(sine_103), .cosine(cosine_105), .strobes(strobes_94)
    );
    strobe_switch switch_96 (
        .strobes(strobes_94), .quarters(quarters), .strobe(selected), .out_of_range(out_of_range)
    );

    // Mark inhibit 100, as late as x and y are.
    wire mark_on;
    delay_element #(.DELAY(4)) delay_start (.clk(clk), .pulse_in(begun), .pulse_out(mark_on));
    delay_element #(.DELAY(2)) delay_stop (.clk(clk), .pulse_in(stop), .pulse_out(ended));
    delay_element #(.DELAY(1)) delay_done (.clk(clk), .pulse_in(ended), .pulse_out(done));
    trigger mark_inhibit_100 (.clk(clk), .set(mark_on), .reset(done), .q(mark));

    // Velocity compensator 102 sees X(t) and Y(t) before they are rounded.
    velocity_compensator #(.WIDTH(48), .VELOCITY_BITS(VELOCITY_BITS), .RATE_BITS(20)) velocity_compensator_102 (
        .clk(clk), .enable(mark), .x(x_88), .y(y_90), .rate(rate_102)
    );

    // Errors.
    wire refused;
    wire beyond;
    wire beyond_now;
    wire wrong;
    and and_refused (refused, start, idle, out_of_range);
    or or_beyond (beyond, overflow_x, overflow_y);
    and and_beyond (beyond_now, beyond, mark);
    or or_wrong (wrong, refused, beyond_now);
    trigger error_trigger (.clk(clk), .set(wrong), .reset(begun), .q(error));
endmodule
