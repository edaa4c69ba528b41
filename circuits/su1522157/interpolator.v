`default_nettype none

// Linear interpolator, SU 1522157 A1 (1989), figure 1.
//
// One frame is one straight segment. It is given by the greater and the lesser of its two absolute projections and
// by which axis has the greater one; a start pulse loads it. Steps come out: a whole step along the major axis
// (36 when that is X, 37 when it is Y), or a combined step of 0.75 along both axes at once (38). With X the major and
// Y the minor projection:
//
//     F >= 0 : whole step,     F := F - Y                        (1)
//     F <  0 : combined step,  F := F + 0.75 (X - Y)
//     F0 = 0.5 (0.75 (X - Y) - Y)                                (2)
//     R  = X - 0.375 - the steps' lengths along the major axis; the frame ends when R < 0      (3)
//
// F stands in adder 1 (net f_1), R in counter 14 (net r_14), both with three fraction digits.
//
// Every block 1 to 22 of the figure is an instance that bears its numeral, and so do the nets: taps 23 to 31, inputs
// 32 to 35, outputs 36 to 38. What stands here and not in the patent says so ("chosen").
//
// Time (chosen). The patent's pulses are strobes of one tick, and all state changes at the end of the tick.
// Delay 13 has to be over before the next strobe of generator 15: DELAY_13 + 1 < CLOCK_PERIOD. A circuit with a
// longer delay is not refused: its counter is read too early, and some frames get one step too many.
//
// What the patent does not say, and the circuit shows:
// - With X = Y = 0 the counter passes below zero at tap 23 already and all is cleared, but the pulse walks on through
//   the distributor and tap 31 opens the gates: one step comes out, on 37 because trigger 5 has been cleared, too (on
//   38 with MINUS_ZERO = 1).
// - The sum of a number and its inverse is all ones: minus zero, whose sign digit is 1, while the text says that the
//   sign of zero is 0. MINUS_ZERO = 0 follows the text; 1 is the end-around carry to the letter, and takes some tied
//   steps in the other order.
// - A start pulse while `busy` is high disturbs the frame under way.
(* WIDTH_min = 1, WIDTH_max = 48, CLOCK_PERIOD_min = 1, CLOCK_PERIOD_max = 65536,
   TAP_SPACING_min = 1, TAP_SPACING_max = 64, DELAY_13_min = 1, DELAY_13_max = 1024,
   DELAY_22_min = 1, DELAY_22_max = 1024, MINUS_ZERO_min = 0, MINUS_ZERO_max = 1 *)
module interpolator #(
    parameter WIDTH = 12,       // bits of a projection
    parameter CLOCK_PERIOD = 4, // ticks from one strobe of generator 15 to the next (chosen; the patent has no times)
    parameter TAP_SPACING = 2,  // ticks from one tap of distributor 20 to the next (chosen)
    parameter DELAY_13 = 1,     // ticks (chosen)
    parameter DELAY_22 = 2,     // ticks (chosen)
    parameter MINUS_ZERO = 0    // 1: a number plus its inverse is minus zero
) (
    input wire clk,
    input wire [WIDTH-1:0] major_32,  // the greater of |X| and |Y|
    input wire start_33,              // "beginning of frame": one tick
    input wire [WIDTH-1:0] minor_34,  // the lesser of |X| and |Y|
    input wire x_is_major_35,         // |X| >= |Y|
    output wire step_x_36,            // a whole step along X
    output wire step_y_37,            // a whole step along Y
    output wire step_xy_38,           // 0.75 of a step along both
    output wire busy                  // chosen: from the tick after start_33 until everything is at rest again
);
    // Erratum: the description's first page gives Y to output 36 and X to 37. Its later pages, table 1 and the claim
    // have X on 36 and Y on 37, as here.

    // Word of 1, 2 and 3: the projection, three fraction digits, one digit of headroom, the sign. The lowest digit
    // weighs 0.125.
    localparam WORD = WIDTH + 5;

    wire tap_23, tap_24, tap_25, tap_26, tap_27, tap_28, tap_29, tap_30, tap_31;
    wire or_6_out, or_7_out, or_8_out, or_9_out, or_10_out, or_11_out, or_12_out;
    wire and_16_out, and_17_out;
    wire strobe_15;
    wire sign_1, sign_inverse_1;
    wire mode_4;
    wire x_is_major_5, y_is_major_5;
    wire overflow_14;
    wire delayed_13, delayed_22;
    wire active_13, active_20, active_22;

    // 20: the pulse distributor. Start pulse 33 walks past taps 23 to 31. Chosen: that 33 feeds it; the text says of 33
    // that it begins the work, and of 20 that it then gives its pulses, but nowhere what enters 20.
    wire [8:0] taps_20;
    pulse_distributor #(.TAPS(9), .SPACING(TAP_SPACING)) distributor_20 (
        .clk(clk),
        .pulse_in(start_33),
        .taps(taps_20),
        .active(active_20)
    );
    assign tap_23 = taps_20[0];
    assign tap_24 = taps_20[1];
    assign tap_25 = taps_20[2];
    assign tap_26 = taps_20[3];
    assign tap_27 = taps_20[4];
    assign tap_28 = taps_20[5];
    assign tap_29 = taps_20[6];
    assign tap_30 = taps_20[7];
    assign tap_31 = taps_20[8];

    // 6 to 12: the OR gates, inputs as the claim lists them.
    or or_6 (or_6_out, tap_24, tap_28);               // adder 1 into register 2
    or or_7 (or_7_out, and_17_out, start_33, tap_26); // register 2 into adder 1
    or or_8 (or_8_out, tap_23, tap_27, overflow_14);  // clear register 2
    or or_9 (or_9_out, tap_25, tap_29);               // shift register 2
    or or_10 (or_10_out, tap_24, tap_25, tap_30);     // shift register 3
    or or_11 (or_11_out, and_16_out, tap_23, tap_29); // register 3, inverted, into adder 1
    or or_12 (or_12_out, tap_24, delayed_13);         // 0.25 out of counter 14

    // 21: the multiplexer. Adder 1 while OR 6 is high, input 32 in the tick of pulse 33, otherwise 0 (table 2). Drawn
    // from gates, as in figure 6, it is the circuit multiplexer_21.
    wire [WORD-1:0] sum_1;
    wire [WORD-1:0] word_21;
    multiplexer #(.WIDTH(WORD)) multiplexer_21 (
        .a(or_6_out),
        .b(start_33),
        .x1(sum_1),
        .x2({5'b00000, major_32}),
        .z(word_21)
    );

    // 2: the first shift register. Erratum: the claim connects the multiplexer with its "outputs"; inputs is right.
    // Chosen: it loads through the set inputs of its digits, because the text, which lists its control inputs, has no
    // load strobe among them (the figure is lost), 21 gives 0 when nothing is to be loaded, and taps 23 and 27 clear it
    // before 24 and 28 load it. It is transparent while it loads: pulse 33 loads it and at once passes its word on to
    // adder 1. "Shifted one digit to the right" in the text doubles the word, so it is towards the high digits. The
    // register holds the sign digit, too: with MINUS_ZERO = 1 and X = Y, tap 24 loads it with minus zero.
    wire [WORD-1:0] transfer_2;
    shift_register #(.WIDTH(WORD), .TRANSPARENT(1), .SET_ONLY(1)) register_2 (
        .clk(clk),
        .word(word_21),
        .load(1'b1),
        .shift(or_9_out),
        .clear(or_8_out),
        .transfer(or_7_out),
        .true_out(transfer_2)
    );

    // 3: the second shift register. It passes on the inverse of its word, so that adder 1 subtracts it. Chosen: pulse
    // 33 is its load strobe; the text only says that the word is written when 33 comes.
    wire [WORD-1:0] transfer_3;
    shift_register #(.WIDTH(WORD), .SET_ONLY(1)) register_3 (
        .clk(clk),
        .word({5'b00000, minor_34}),
        .load(start_33),
        .shift(or_10_out),
        .clear(overflow_14),
        .transfer(or_11_out),
        .inverse_out(transfer_3)
    );

    // 1: the accumulating adder, one's complement with end-around carry; it holds F.
    // Erratum: in the negative branch the text adds "register 3 ... until negative": register 2, until no longer so.
    (* fraction = 3 *) wire signed [WORD-1:0] f_1;
    ones_complement_accumulator #(.WIDTH(WORD), .MINUS_ZERO(MINUS_ZERO)) accumulator_1 (
        .clk(clk),
        .first(transfer_2),
        .second(transfer_3),
        .clear(overflow_14),
        .sum(sum_1),
        .value(f_1),
        .sign(sign_1),
        .sign_inverse(sign_inverse_1)
    );

    // 4: the mode trigger, 1 while the frame is stepped. Erratum: the text once calls 4 and 5 registers.
    trigger trigger_4 (.clk(clk), .set(tap_31), .reset(overflow_14), .q(mode_4));

    // 5: the sign trigger, 1 when X is the major axis. In the patent the signal on 35 is a pulse given with pulse 33;
    // here 35 is a level, and the gate and_35 (chosen) makes that pulse of it.
    wire x_is_major_33;
    and and_35 (x_is_major_33, x_is_major_35, start_33);
    trigger trigger_5 (
        .clk(clk),
        .set(x_is_major_33),
        .reset(overflow_14),
        .q(x_is_major_5),
        .q_inverse(y_is_major_5)
    );

    // 15: the clock generator. Chosen: it runs freely from tick 0.
    clock_generator #(.PERIOD(CLOCK_PERIOD)) generator_15 (.clk(clk), .strobe(strobe_15));

    // 16 to 19: the AND gates. Erratum: the text once has combined steps come from AND 16; they come from AND 17.
    and and_16 (and_16_out, sign_inverse_1, mode_4, strobe_15);
    and and_17 (and_17_out, sign_1, mode_4, strobe_15);
    and and_18 (step_x_36, and_16_out, x_is_major_5);
    and and_19 (step_y_37, and_16_out, y_is_major_5);
    assign step_xy_38 = and_17_out;

    // 13: the late 0.25 of a combined step's 0.5 + 0.25.
    delay_element #(.DELAY(DELAY_13)) delay_13 (
        .clk(clk),
        .pulse_in(and_17_out),
        .pulse_out(delayed_13),
        .active(active_13)
    );

    // 14: the subtracting counter, with the three fraction digits that are the invention's; it holds R. Count inputs:
    // 1, 0.5, 0.25 and 0.125. Chosen: pulse 33 loads it. The claim clears by the "inverse output of its top digit",
    // the text by its overflow pulse, which is meant here: one tick, when the count has passed below zero.
    (* fraction = 3 *) wire signed [WIDTH+3:0] r_14;
    subtracting_counter #(.WIDTH(WIDTH), .FRACTION(3)) counter_14 (
        .clk(clk),
        .word(major_32),
        .load(start_33),
        .subtract({and_16_out, and_17_out, or_12_out, tap_23}),
        .clear(delayed_22),
        .count(r_14),
        .overflow(overflow_14)
    );

    // 22: the counter clears itself, later than all the rest.
    delay_element #(.DELAY(DELAY_22)) delay_22 (
        .clk(clk),
        .pulse_in(overflow_14),
        .pulse_out(delayed_22),
        .active(active_22)
    );

    // Chosen: the patent has no such output. A frame is over when no pulse is under way any more.
    or or_busy (busy, active_20, mode_4, active_13, overflow_14, active_22);
endmodule
