`default_nettype none

// The prototype of SU 1522157 A1: the linear interpolator that it improves (author's certificate 1089551), with whole steps
// and combined steps of (1, 1), that is a diagonal of 1.414. Figure 4 shows its path, curve 2 of figure 5 its error.
//
//     F >= 0 : whole step,           F := F - Y
//     F <  0 : combined step (1, 1), F := F + (X - Y)
//     F0 = 0.5 ((X - Y) - Y)
//     R  = X - 1 - the number of steps; the frame ends when R < 0
//
// Its circuit is not in the text; this one is chosen. It is figure 1 without what the claim's distinguishing part adds
// (multiplexer 21, the three fraction digits of counter 14, and the taps of distributor 20 that serve them); what is left
// bears the numerals of figure 1, does what it does there, and is wired as the claim's first part says:
// - without 21 the greater projection goes into adder 1 itself (gates 33), and register 2 takes its word from there alone.
// - 0.75 has not to be formed: taps 25 to 28 are gone, and with them OR gates 6, 8, 9, 10. A frame takes taps 23 (X - Y),
//   24 (which goes into register 2), 29 (F0), 30 (register 3 holds Y), and 31 (stepping begins).
// - The loads weigh 0.5, so that F0 needs no halving; the shifts at 29 and 30 restore the words.
// - Counter 14 takes 1 for each step of either kind, so there is no late part of it: delay 13 is gone. Tap 23 takes the 1
//   by which R is below zero just after the last step, as 0.375 does in figure 1.
// - A frame of no length gives one step, as there.
(* WIDTH_min = 1, WIDTH_max = 48, CLOCK_PERIOD_min = 1, CLOCK_PERIOD_max = 65536,
   TAP_SPACING_min = 1, TAP_SPACING_max = 64,
   DELAY_22_min = 1, DELAY_22_max = 1024, MINUS_ZERO_min = 0, MINUS_ZERO_max = 1 *)
module prototype #(
    parameter WIDTH = 12,       // bits of a projection
    parameter CLOCK_PERIOD = 4, // ticks from one strobe of generator 15 to the next, at least 3 (chosen)
    parameter TAP_SPACING = 2,  // ticks from one tap of distributor 20 to the next (chosen)
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
    output wire step_xy_38,           // a whole step along both
    output wire busy                  // from the tick after start_33 until everything is at rest again
);
    // The projection, one fraction digit, one digit of headroom, the sign. The lowest digit weighs 0.5.
    localparam WORD = WIDTH + 3;

    wire tap_23, tap_24, tap_29, tap_30, tap_31;
    wire or_11_out, or_12_out;
    wire and_16_out, and_17_out;
    wire strobe_15;
    wire sign_1, sign_inverse_1;
    wire mode_4;
    wire x_is_major_5, y_is_major_5;
    wire overflow_14, delayed_22;
    wire active_20, active_22;

    // 20: the pulse distributor, five taps of its nine.
    wire [4:0] taps_20;
    pulse_distributor #(.TAPS(5), .SPACING(TAP_SPACING)) distributor_20 (
        .clk(clk),
        .pulse_in(start_33),
        .taps(taps_20),
        .active(active_20)
    );
    assign tap_23 = taps_20[0];
    assign tap_24 = taps_20[1];
    assign tap_29 = taps_20[2];
    assign tap_30 = taps_20[3];
    assign tap_31 = taps_20[4];

    or or_11 (or_11_out, and_16_out, tap_23, tap_29);     // register 3, inverted, into adder 1
    or or_12 (or_12_out, and_16_out, and_17_out, tap_23); // 1 out of counter 14

    // The greater projection into adder 1, in the tick of pulse 33.
    wire [WORD-1:0] major_33;
    word_gate #(.WIDTH(WORD)) gates_33 (.open(start_33), .word({3'b000, major_32}), .passed(major_33));

    // 2: the first shift register.
    wire [WORD-1:0] sum_1;
    wire [WORD-1:0] transfer_2;
    shift_register #(.WIDTH(WORD)) register_2 (
        .clk(clk),
        .word(sum_1),
        .load(tap_24),
        .shift(tap_29),
        .clear(overflow_14),
        .transfer(and_17_out),
        .true_out(transfer_2)
    );

    // 3: the second shift register, passed on inverted.
    wire [WORD-1:0] transfer_3;
    shift_register #(.WIDTH(WORD), .SET_ONLY(1)) register_3 (
        .clk(clk),
        .word({3'b000, minor_34}),
        .load(start_33),
        .shift(tap_30),
        .clear(overflow_14),
        .transfer(or_11_out),
        .inverse_out(transfer_3)
    );

    // 1: the accumulating adder; it holds F. Its first operand comes from the gates or from register 2.
    wire [WORD-1:0] first_1;
    genvar digit;
    generate
        for (digit = 0; digit < WORD; digit = digit + 1) begin : operand
            or or_1 (first_1[digit], major_33[digit], transfer_2[digit]);
        end
    endgenerate
    (* fraction = 1 *) wire signed [WORD-1:0] f_1;
    ones_complement_accumulator #(.WIDTH(WORD), .MINUS_ZERO(MINUS_ZERO)) accumulator_1 (
        .clk(clk),
        .first(first_1),
        .second(transfer_3),
        .clear(overflow_14),
        .sum(sum_1),
        .value(f_1),
        .sign(sign_1),
        .sign_inverse(sign_inverse_1)
    );

    // 4 and 5: the mode trigger and the sign trigger; gate and_35 as in the interpolator.
    trigger trigger_4 (.clk(clk), .set(tap_31), .reset(overflow_14), .q(mode_4));
    wire x_is_major_33;
    and and_35 (x_is_major_33, x_is_major_35, start_33);
    trigger trigger_5 (
        .clk(clk),
        .set(x_is_major_33),
        .reset(overflow_14),
        .q(x_is_major_5),
        .q_inverse(y_is_major_5)
    );

    // 15: the clock generator.
    clock_generator #(.PERIOD(CLOCK_PERIOD)) generator_15 (.clk(clk), .strobe(strobe_15));

    // 16 to 19: the AND gates.
    and and_16 (and_16_out, sign_inverse_1, mode_4, strobe_15);
    and and_17 (and_17_out, sign_1, mode_4, strobe_15);
    and and_18 (step_x_36, and_16_out, x_is_major_5);
    and and_19 (step_y_37, and_16_out, y_is_major_5);
    assign step_xy_38 = and_17_out;

    // 14: the subtracting counter, without fraction digits; it holds R.
    wire signed [WIDTH:0] r_14;
    subtracting_counter #(.WIDTH(WIDTH), .FRACTION(0)) counter_14 (
        .clk(clk),
        .word(major_32),
        .load(start_33),
        .subtract(or_12_out),
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

    or or_busy (busy, active_20, mode_4, overflow_14, active_22);
endmodule
