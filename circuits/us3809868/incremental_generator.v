`default_nettype none

// Incremental function generator, US 3,809,868 (1974), FIG. 9, with the pulse generators and the time control of
// FIG. 10 inside. FIG. 1 calls it 16.
//
// It draws  X(t) = J (cos t - 1) + K sin t + X0,  Y(t) = L (cos t - 1) + M sin t + Y0  over one to four quarters of
// t = 0 .. 2 pi, as pulses: a pulse of generator 272 is a unit of |d cos|, one of 274 a unit of |d sin|; multipliers
// 262 to 270 scale them by the coefficients, 298 and 308 find the direction, counters 318 and 320 hold X and Y.
//
// The end points are exact by construction, X0-J+K, X0-2J, X0-J-K, X0 after one to four quarters (and likewise Y),
// because each generator gives just 2^WIDTH pulses a quarter:
// - the words of tables 333 and 334 sum to 2^WIDTH (differences of rounded sines, see block table_memory);
// - each word is held for one round of 325 and 327, 2^ENTRY_WIDTH clocks, which gives just so many pulses;
// - so each of 262 to 270 makes one full round a quarter and passes just |J|, |K|, |L|, |M| pulses;
// - pulses of 272 and 274 never coincide: those of 272 are delayed by half a clock.
// The last clock of each word passes no pulse, so that the delayed half never falls into the next word or quadrant.
//
// Time: a clock of 329 has two halves of HALF ticks. The first half carries the pulses of 274 (sine), the second those
// of 272 (cosine). A pulse is on for all ticks of its half but the last, longer when 329 is held. In that last tick all
// pulses are off, so that each has edges of its own on lines 304, 306, 314, 316, and two pulses never touch (chosen:
// the figures show no pulse shapes, but counters, delay circuits and motors answer edges). Counters 318 and 320 count
// at the trailing edge on their lines: X and Y change at the end of the half.
// A quarter takes ENTRIES * 2^ENTRY_WIDTH clocks, 8192 with the defaults.
//
// Start: `start` high for one tick, with all other inputs valid in that tick. From the next tick on `busy` is high
// until the stroke ends; `done` is high for one tick after that, when X and Y are at their end.
//
// Errors. A start is refused, nothing moves, and `error` goes high with the next tick when
// - a coefficient's magnitude is more than 2^(WIDTH-GUARD) - 1 (so -4096 cannot be drawn with 12 bits): 4 detectors;
// - `quarters` is 0 or more than 4;
// - a stroke is still under way. That stroke goes on unharmed to its right end.
// `done` follows a refused start, too, unless a stroke is under way. `error` also goes high when a counter is carried
// beyond its 16 bits, and would if two pulses met in 290 or 292. It stays high until the next start that is accepted.
//
// From the text: every block with a numeral. Chosen: all numbers of bits, the registers in 300 to 312 and 349 that
// keep the inputs during a stroke, the check of the inputs, the guard stages. Errata followed: 327 is the cosine
// multiplier, 329 the clock; "sine function" for the rate of 274 is a slip, the rate of its pulses is a cosine; the
// count-up table is damaged in print (row 1 reads like row 4) and restored from the signs of d(cos) and d(sin).
// Outside: converters 322 and 324 and display 326, which would show X and Y (here they stay numbers), and the incremental
// device 328 on the four lines (see fig10_system).
(* WIDTH_min = 1, WIDTH_max = 16, ENTRIES_min = 2, ENTRIES_max = 4096, ENTRY_WIDTH_min = 1, ENTRY_WIDTH_max = 16,
   GUARD_min = 0, GUARD_max = 3, HALF_min = 2, HALF_max = 1024 *)
module incremental_generator #(
    parameter WIDTH = 12,       // bits of multipliers 262 to 270
    parameter ENTRIES = 128,    // words of tables 333 and 334, a power of two
    parameter ENTRY_WIDTH = 6,  // bits of these words, of multipliers 325 and 327 and of counter 336
    parameter GUARD = 0,        // guard stages below counters 318 and 320, 0 to 3: the path gets smoother by their
                                // rounding, the coefficients lose as many bits (chosen)
    parameter HALF = 2          // ticks of half a clock, 2 at least
) (
    input wire clk,
    input wire start,
    input wire signed [15:0] j,
    input wire signed [15:0] k,
    input wire signed [15:0] l,
    input wire signed [15:0] m,
    input wire signed [15:0] x0,
    input wire signed [15:0] y0,
    input wire [2:0] quarters,      // 1 to 4
    input wire hold,                // HOLD of clock 329: a pulse that is on stays on
    input wire inhibit,             // no clock pulse begins (claim 17)
    input wire fast,                // full velocity: half a clock is two ticks, whatever HALF is (FIG. 16)
    output wire signed [15:0] x,    // counter 318
    output wire signed [15:0] y,    // counter 320
    output wire up_304,             // X pulses
    output wire down_306,
    output wire up_314,             // Y pulses
    output wire down_316,
    output wire pulse_290,          // elements of X: the pulses of 262 and 264, before any guard stages
    output wire pulse_292,          // elements of Y: those of 268 and 270
    output wire started,            // 1 in the tick of a start that is accepted
    output wire busy,               // flip-flop 348
    output wire done,
    output wire error
);
    localparam ADDRESS_WIDTH = $clog2(ENTRIES);

    wire clear;
    wire stop;
    wire phase_a, phase_b, trailing_329, end_of_clock;

    // The check of a start (chosen).
    wire bad_300, bad_302, bad_310, bad_312, bad_349;
    wire bad_input, good_input, idle;
    wire refused, refused_busy, refused_idle;
    or or_bad_input (bad_input, bad_300, bad_302, bad_310, bad_312, bad_349);
    not not_bad_input (good_input, bad_input);
    not not_busy (idle, busy);
    and and_started (started, start, idle, good_input);
    and and_refused (refused, start, bad_input);
    and and_refused_busy (refused_busy, start, busy);
    and and_refused_idle (refused_idle, refused, idle);
    assign clear = started;

    // The error flip-flop (chosen).
    wire coincident_290, coincident_292;
    wire overflow_318, overflow_320;
    wire fault;
    or or_fault (fault, refused, refused_busy, coincident_290, coincident_292, overflow_318, overflow_320);
    trigger trigger_error (.clk(clk), .set(fault), .reset(started), .q(error), .q_inverse());

    // `done` (chosen).
    wire finished;
    or or_finished (finished, stop, refused_idle);
    delay_element #(.DELAY(1)) delay_done (.clk(clk), .pulse_in(finished), .pulse_out(done), .active());

    // Time control 278. 348: the flip-flop that START sets and 349 resets. 329: the clock it enables.
    trigger flip_flop_348 (.clk(clk), .set(started), .reset(stop), .q(busy), .q_inverse());
    two_phase_clock #(.HALF(HALF)) clock_329 (
        .clk(clk),
        .run(busy),
        .hold(hold),
        .inhibit(inhibit),
        .fast(fast),
        .phase_a(phase_a),
        .phase_b(phase_b),
        .trailing(trailing_329),
        .end_of_clock(end_of_clock)
    );

    // 336 counts the clocks of a word, 335 the words, 337 the quadrants. They step at the end of a clock.
    wire end_of_word, end_of_quadrant;
    wire [ADDRESS_WIDTH-1:0] address_335;
    wire [1:0] quadrant_337;
    binary_counter #(.WIDTH(ENTRY_WIDTH)) counter_336 (
        .clk(clk),
        .clear(clear),
        .step(end_of_clock),
        .count(),
        .overflow(end_of_word)
    );
    binary_counter #(.WIDTH(ADDRESS_WIDTH)) counter_335 (
        .clk(clk),
        .clear(clear),
        .step(end_of_word),
        .count(address_335),
        .overflow(end_of_quadrant)
    );
    binary_counter #(.WIDTH(2)) counter_337 (
        .clk(clk),
        .clear(clear),
        .step(end_of_quadrant),
        .count(quadrant_337),
        .overflow()
    );
    wire [3:0] lines_332;
    decoder #(.LINES(4)) decoder_332 (.code(quadrant_337), .lines(lines_332));
    stop_switch switch_349 (
        .clk(clk),
        .load(started),
        .quarters(quarters),
        .quadrant_lines(lines_332),
        .end_of_quadrant(end_of_quadrant),
        .stop(stop),
        .out_of_range(bad_349)
    );

    // Tables 333 and 334; switches 330 and 331 exchange them in quadrants 2 and 4.
    wire [ENTRY_WIDTH-1:0] word_333, word_334, word_330, word_331;
    wire even_quadrant;
    or or_even_quadrant (even_quadrant, lines_332[1], lines_332[3]);
    table_memory #(.ENTRIES(ENTRIES), .WIDTH(ENTRY_WIDTH), .SUM_BITS(WIDTH), .REVERSED(0)) table_333 (
        .address(address_335),
        .word(word_333)
    );
    table_memory #(.ENTRIES(ENTRIES), .WIDTH(ENTRY_WIDTH), .SUM_BITS(WIDTH), .REVERSED(1)) table_334 (
        .address(address_335),
        .word(word_334)
    );
    quadrant_switch #(.WIDTH(ENTRY_WIDTH)) switch_330 (
        .odd_table(word_333),
        .even_table(word_334),
        .even_quadrant(even_quadrant),
        .word(word_330)
    );
    quadrant_switch #(.WIDTH(ENTRY_WIDTH)) switch_331 (
        .odd_table(word_334),
        .even_table(word_333),
        .even_quadrant(even_quadrant),
        .word(word_331)
    );

    // 325 is the sine generator 274. 327, its output delayed by half a clock, is the cosine generator 272.
    wire pulse_274, pulse_327, pulse_272;
    binary_rate_multiplier #(.WIDTH(ENTRY_WIDTH)) multiplier_325 (
        .clk(clk),
        .clear(clear),
        .pulse(phase_a),
        .trailing(trailing_329),
        .rate(word_330),
        .out(pulse_274),
        .overflow()
    );
    binary_rate_multiplier #(.WIDTH(ENTRY_WIDTH)) multiplier_327 (
        .clk(clk),
        .clear(clear),
        .pulse(phase_a),
        .trailing(trailing_329),
        .rate(word_331),
        .out(pulse_327),
        .overflow()
    );
    half_clock_delay delay_327 (
        .clk(clk),
        .pulse(pulse_327),
        .trailing(trailing_329),
        .second_half(phase_b),
        .out(pulse_272)
    );

    // 300, 302, 310, 312: the polarity detectors, which keep sign and magnitude during the stroke.
    wire negative_300, negative_302, negative_310, negative_312;
    wire [WIDTH-1:0] magnitude_j, magnitude_k, magnitude_l, magnitude_m;
    polarity_detector #(.WIDTH(16), .MAGNITUDE_WIDTH(WIDTH), .GUARD(GUARD)) detector_300 (
        .clk(clk),
        .load(started),
        .word(j),
        .negative(negative_300),
        .magnitude(magnitude_j),
        .out_of_range(bad_300)
    );
    polarity_detector #(.WIDTH(16), .MAGNITUDE_WIDTH(WIDTH), .GUARD(GUARD)) detector_302 (
        .clk(clk),
        .load(started),
        .word(k),
        .negative(negative_302),
        .magnitude(magnitude_k),
        .out_of_range(bad_302)
    );
    polarity_detector #(.WIDTH(16), .MAGNITUDE_WIDTH(WIDTH), .GUARD(GUARD)) detector_310 (
        .clk(clk),
        .load(started),
        .word(m),
        .negative(negative_310),
        .magnitude(magnitude_m),
        .out_of_range(bad_310)
    );
    polarity_detector #(.WIDTH(16), .MAGNITUDE_WIDTH(WIDTH), .GUARD(GUARD)) detector_312 (
        .clk(clk),
        .load(started),
        .word(l),
        .negative(negative_312),
        .magnitude(magnitude_l),
        .out_of_range(bad_312)
    );

    // 262 to 270: pulses of 272 times J and L, pulses of 274 times K and M.
    wire pulse_262, pulse_264, pulse_268, pulse_270;
    binary_rate_multiplier #(.WIDTH(WIDTH)) multiplier_262 (
        .clk(clk),
        .clear(clear),
        .pulse(pulse_272),
        .trailing(trailing_329),
        .rate(magnitude_j),
        .out(pulse_262),
        .overflow()
    );
    binary_rate_multiplier #(.WIDTH(WIDTH)) multiplier_264 (
        .clk(clk),
        .clear(clear),
        .pulse(pulse_274),
        .trailing(trailing_329),
        .rate(magnitude_k),
        .out(pulse_264),
        .overflow()
    );
    binary_rate_multiplier #(.WIDTH(WIDTH)) multiplier_268 (
        .clk(clk),
        .clear(clear),
        .pulse(pulse_274),
        .trailing(trailing_329),
        .rate(magnitude_m),
        .out(pulse_268),
        .overflow()
    );
    binary_rate_multiplier #(.WIDTH(WIDTH)) multiplier_270 (
        .clk(clk),
        .clear(clear),
        .pulse(pulse_272),
        .trailing(trailing_329),
        .rate(magnitude_l),
        .out(pulse_270),
        .overflow()
    );

    // X: interleaver 290, direction control 298, pulse switch 294, counter 318.
    wire direction_298, up_294, down_294;
    pulse_interleaver interleaver_290 (
        .a(pulse_262),
        .b(pulse_264),
        .out(pulse_290),
        .coincident(coincident_290)
    );
    direction_control control_298 (
        .quadrant(quadrant_337),
        .negative_cosine(negative_300),
        .negative_sine(negative_302),
        .cosine(phase_b),
        .up(direction_298)
    );
    pulse_switch switch_294 (
        .pulse(pulse_290),
        .up(direction_298),
        .up_line(up_294),
        .down_line(down_294)
    );
    // Lines 304 and 306 are taken behind the guard stages, where there are any: they carry whole counts.
    reversible_counter #(.WIDTH(16), .GUARD(GUARD)) counter_318 (
        .clk(clk),
        .preset(started),
        .preset_value(x0),
        .up(up_294),
        .down(down_294),
        .count(x),
        .carry(up_304),
        .borrow(down_306),
        .overflow(overflow_318)
    );

    // Y: interleaver 292, direction control 308, pulse switch 296, counter 320.
    wire direction_308, up_296, down_296;
    pulse_interleaver interleaver_292 (
        .a(pulse_270),
        .b(pulse_268),
        .out(pulse_292),
        .coincident(coincident_292)
    );
    direction_control control_308 (
        .quadrant(quadrant_337),
        .negative_cosine(negative_312),
        .negative_sine(negative_310),
        .cosine(phase_b),
        .up(direction_308)
    );
    pulse_switch switch_296 (
        .pulse(pulse_292),
        .up(direction_308),
        .up_line(up_296),
        .down_line(down_296)
    );
    reversible_counter #(.WIDTH(16), .GUARD(GUARD)) counter_320 (
        .clk(clk),
        .preset(started),
        .preset_value(y0),
        .up(up_296),
        .down(down_296),
        .count(y),
        .carry(up_314),
        .borrow(down_316),
        .overflow(overflow_320)
    );
endmodule
