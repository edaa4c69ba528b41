// FIG. 20 of US 3,809,868: rotation of a stroke in space, about X, Y and Z one after another.
//
// The stroke is X(t) = J (cos t - 1) + K sin t, Y(t) = L (cos t - 1) + M sin t, Z(t) = N (cos t - 1) + P sin t, seen
// from its initial point, which stays. Registers 618 hold the six coefficients. In each of three states of counter 614
// decoder 616 opens one of the gates: 620 sends L, M, N, P to circuit 626 (about X, by angle alpha 628) and passes J
// and K; 622 sends N, P, J, K to 630 (about Y, by phi 632) and passes L and M; 624 sends J, K, L, M to 634 (about Z, by
// theta 636) and passes N and P. A gate that is closed gives 0 and its circuit turns 0 into 0, so the or network 638
// joins what there is. Multiplexer 612 connects 618 to the inputs in the first state, to 638 in those that follow.
// State 1 loads and rotates; the result stands at 638 in state 3.
//
//   626: L' = L cos - N sin   M' = M cos - P sin   N' = L sin + N cos   P' = M sin + P cos
//   630: N' = N cos - J sin   P' = P cos - K sin   J' = N sin + J cos   K' = P sin + K cos
//   634: J' = J cos - L sin   K' = K cos - M sin   L' = J sin + L cos   M' = K sin + M cos
//
// Each is the circuit of FIG. 12, as the text allows, with the two axes in the order y to z, z to x, x to y: positive
// angles turn that way, right-handed. The equations are lost in print, and with them the sign of phi, which is chosen.
//
// Errata: "multiplexer 512" is 612; "network 636" is 638 (636 is the source of theta); J to M do not pass through 616,
// which controls 612 and the gates.
//
// order_616: three codes of two bits, first rotation lowest; 1 = X, 2 = Y, 3 = Z, 0 = no rotation. All codes are
// allowed in any order. The angles: 16 bits, 2^16 a full turn. Each rotation rounds to whole counts: after three the
// result is within 2 counts of the exact one.
// `error`: a result of a rotation beyond 16 bits.
//
// Chosen, where the patent is silent:
//  - a rank is one tick but for the rotation, which takes five; 614 steps when 638 has taken the result of a state, so
//    that 638 holds it while 618 takes it in the next; it rests in its first state;
//  - a fourth gate without numeral, gate_through, passes all six for code 0;
//  - all three circuits start together: those behind closed gates have to give 0;
//  - the inputs are kept from the tick of `start` on; `done` rises when the result stands, and stays until the next
//    start; `error` goes with it, and the outputs are then 0. A start while busy is ignored.
// Generators 640 (X, Y) and 642 (Z) are outside: see fig20_display.
`default_nettype none

module fig20_rotation3d (
    input wire clk,
    input wire start,
    input wire [5:0] order_616,
    input wire [15:0] angle_628,
    input wire [15:0] angle_632,
    input wire [15:0] angle_636,
    input wire signed [15:0] j,
    input wire signed [15:0] k,
    input wire signed [15:0] l,
    input wire signed [15:0] m,
    input wire signed [15:0] n,
    input wire signed [15:0] p,
    output wire signed [15:0] j_out,
    output wire signed [15:0] k_out,
    output wire signed [15:0] l_out,
    output wire signed [15:0] m_out,
    output wire signed [15:0] n_out,
    output wire signed [15:0] p_out,
    output wire done,
    output wire error
);
    // The sequence: in each state 618 is loaded, the circuits turn, 638 takes their result.
    wire load;
    wire [8:0] rank;
    wire reload;
    wire load_618;
    wire turn;
    wire combine;
    wire step_614;
    wire finish;
    or or_reload (reload, rank[2], rank[5]);
    or or_load_618 (load_618, load, reload);
    or or_turn (turn, rank[0], rank[3], rank[6]);
    or or_combine (combine, rank[1], rank[4], rank[7]);
    or or_step_614 (step_614, rank[1], rank[4]);
    assign finish = rank[8];

    // The sequencer waits while the circuits turn.
    wire done_626;
    wire done_630;
    wire done_634;
    wire turned;
    wire at_rest;
    wire ready;
    and and_turned (turned, done_626, done_630, done_634);
    trigger turning (.clk(clk), .set(turn), .reset(combine), .q_inverse(at_rest));
    or or_ready (ready, at_rest, turned);
    rank_sequencer #(.RANKS(9)) rank_sequencer (
        .clk(clk), .start(start), .ready(ready), .load(load), .rank(rank), .done(done)
    );

    // Counter 614 and decoder 616.
    wire [1:0] state_614;
    wire first_state;
    wire later_state;
    wire [3:0] lines_616;
    binary_counter #(.WIDTH(2)) counter_614 (.clk(clk), .clear(finish), .step(step_614), .count(state_614));
    or or_later (later_state, state_614[1], state_614[0]);
    not not_later (first_state, later_state);
    presettable_decoder decoder_616 (
        .clk(clk), .preset(load), .order(order_616), .state(state_614), .lines(lines_616)
    );

    // Sources 628, 632, 636.
    wire [15:0] alpha_628;
    wire [15:0] phi_632;
    wire [15:0] theta_636;
    register #(.WIDTH(16)) source_628 (.clk(clk), .word(angle_628), .enable(load), .clear(1'b0), .q(alpha_628));
    register #(.WIDTH(16)) source_632 (.clk(clk), .word(angle_632), .enable(load), .clear(1'b0), .q(phi_632));
    register #(.WIDTH(16)) source_636 (.clk(clk), .word(angle_636), .enable(load), .clear(1'b0), .q(theta_636));

    // Multiplexer 612 and registers 618.
    wire signed [15:0] j_638;
    wire signed [15:0] j_612;
    wire signed [15:0] j_618;
    multiplexer #(.WIDTH(16)) multiplexer_j_612 (
        .a(first_state), .b(later_state), .x1(j), .x2(j_638), .z(j_612)
    );
    register #(.WIDTH(16)) register_j_618 (
        .clk(clk), .word(j_612), .enable(load_618), .clear(1'b0), .q(j_618)
    );
    wire signed [15:0] k_638;
    wire signed [15:0] k_612;
    wire signed [15:0] k_618;
    multiplexer #(.WIDTH(16)) multiplexer_k_612 (
        .a(first_state), .b(later_state), .x1(k), .x2(k_638), .z(k_612)
    );
    register #(.WIDTH(16)) register_k_618 (
        .clk(clk), .word(k_612), .enable(load_618), .clear(1'b0), .q(k_618)
    );
    wire signed [15:0] l_638;
    wire signed [15:0] l_612;
    wire signed [15:0] l_618;
    multiplexer #(.WIDTH(16)) multiplexer_l_612 (
        .a(first_state), .b(later_state), .x1(l), .x2(l_638), .z(l_612)
    );
    register #(.WIDTH(16)) register_l_618 (
        .clk(clk), .word(l_612), .enable(load_618), .clear(1'b0), .q(l_618)
    );
    wire signed [15:0] m_638;
    wire signed [15:0] m_612;
    wire signed [15:0] m_618;
    multiplexer #(.WIDTH(16)) multiplexer_m_612 (
        .a(first_state), .b(later_state), .x1(m), .x2(m_638), .z(m_612)
    );
    register #(.WIDTH(16)) register_m_618 (
        .clk(clk), .word(m_612), .enable(load_618), .clear(1'b0), .q(m_618)
    );
    wire signed [15:0] n_638;
    wire signed [15:0] n_612;
    wire signed [15:0] n_618;
    multiplexer #(.WIDTH(16)) multiplexer_n_612 (
        .a(first_state), .b(later_state), .x1(n), .x2(n_638), .z(n_612)
    );
    register #(.WIDTH(16)) register_n_618 (
        .clk(clk), .word(n_612), .enable(load_618), .clear(1'b0), .q(n_618)
    );
    wire signed [15:0] p_638;
    wire signed [15:0] p_612;
    wire signed [15:0] p_618;
    multiplexer #(.WIDTH(16)) multiplexer_p_612 (
        .a(first_state), .b(later_state), .x1(p), .x2(p_638), .z(p_612)
    );
    register #(.WIDTH(16)) register_p_618 (
        .clk(clk), .word(p_612), .enable(load_618), .clear(1'b0), .q(p_618)
    );

    // The gates.
    wire signed [15:0] j_through, k_through, l_through, m_through, n_through, p_through;
    coefficient_gate gate_through (
        .open(lines_616[0]),
        .j(j_618), .k(k_618), .l(l_618), .m(m_618), .n(n_618), .p(p_618),
        .j_passed(j_through), .k_passed(k_through), .l_passed(l_through),
        .m_passed(m_through), .n_passed(n_through), .p_passed(p_through)
    );
    wire signed [15:0] j_620, k_620, l_620, m_620, n_620, p_620;
    coefficient_gate gate_620 (
        .open(lines_616[1]),
        .j(j_618), .k(k_618), .l(l_618), .m(m_618), .n(n_618), .p(p_618),
        .j_passed(j_620), .k_passed(k_620), .l_passed(l_620),
        .m_passed(m_620), .n_passed(n_620), .p_passed(p_620)
    );
    wire signed [15:0] j_622, k_622, l_622, m_622, n_622, p_622;
    coefficient_gate gate_622 (
        .open(lines_616[2]),
        .j(j_618), .k(k_618), .l(l_618), .m(m_618), .n(n_618), .p(p_618),
        .j_passed(j_622), .k_passed(k_622), .l_passed(l_622),
        .m_passed(m_622), .n_passed(n_622), .p_passed(p_622)
    );
    wire signed [15:0] j_624, k_624, l_624, m_624, n_624, p_624;
    coefficient_gate gate_624 (
        .open(lines_616[3]),
        .j(j_618), .k(k_618), .l(l_618), .m(m_618), .n(n_618), .p(p_618),
        .j_passed(j_624), .k_passed(k_624), .l_passed(l_624),
        .m_passed(m_624), .n_passed(n_624), .p_passed(p_624)
    );

    // The rotations.
    wire signed [15:0] l_626, m_626, n_626, p_626;
    wire error_626;
    fig12_rotation rotation_626 (
        .clk(clk), .start(turn), .angle_410(alpha_628),
        .j(l_620), .k(m_620), .l(n_620), .m(p_620),
        .j_out(l_626), .k_out(m_626), .l_out(n_626), .m_out(p_626),
        .done(done_626), .error(error_626)
    );
    wire signed [15:0] n_630, p_630, j_630, k_630;
    wire error_630;
    fig12_rotation rotation_630 (
        .clk(clk), .start(turn), .angle_410(phi_632),
        .j(n_622), .k(p_622), .l(j_622), .m(k_622),
        .j_out(n_630), .k_out(p_630), .l_out(j_630), .m_out(k_630),
        .done(done_630), .error(error_630)
    );
    wire signed [15:0] j_634, k_634, l_634, m_634;
    wire error_634;
    fig12_rotation rotation_634 (
        .clk(clk), .start(turn), .angle_410(theta_636),
        .j(j_624), .k(k_624), .l(l_624), .m(m_624),
        .j_out(j_634), .k_out(k_634), .l_out(l_634), .m_out(m_634),
        .done(done_634), .error(error_634)
    );

    // Network 638.
    or_network #(.WIDTH(16)) network_j_638 (
        .clk(clk), .strobe(combine), .a(j_620), .b(j_630), .c(j_634), .d(j_through), .word(j_638)
    );
    or_network #(.WIDTH(16)) network_k_638 (
        .clk(clk), .strobe(combine), .a(k_620), .b(k_630), .c(k_634), .d(k_through), .word(k_638)
    );
    or_network #(.WIDTH(16)) network_l_638 (
        .clk(clk), .strobe(combine), .a(l_626), .b(l_622), .c(l_634), .d(l_through), .word(l_638)
    );
    or_network #(.WIDTH(16)) network_m_638 (
        .clk(clk), .strobe(combine), .a(m_626), .b(m_622), .c(m_634), .d(m_through), .word(m_638)
    );
    or_network #(.WIDTH(16)) network_n_638 (
        .clk(clk), .strobe(combine), .a(n_626), .b(n_630), .c(n_624), .d(n_through), .word(n_638)
    );
    or_network #(.WIDTH(16)) network_p_638 (
        .clk(clk), .strobe(combine), .a(p_626), .b(p_630), .c(p_624), .d(p_through), .word(p_638)
    );

    // A result of any state that did not fit.
    wire beyond;
    wire beyond_now;
    wire wrong;
    or or_beyond (beyond, error_626, error_630, error_634);
    and and_beyond (beyond_now, beyond, combine);
    trigger wrong_trigger (.clk(clk), .set(beyond_now), .reset(load), .q(wrong));

    // The results are taken in the last rank, refused when anything is wrong.
    wire refuse;
    and and_refuse (refuse, finish, wrong);
    converter_outputs outputs (
        .clk(clk), .load(load), .finish(finish), .wrong(wrong),
        .j_word(j_638), .k_word(k_638), .l_word(l_638), .m_word(m_638),
        .j(j_out), .k(k_out), .l(l_out), .m(m_out), .error(error)
    );
    register #(.WIDTH(16)) register_n (.clk(clk), .word(n_638), .enable(finish), .clear(refuse), .q(n_out));
    register #(.WIDTH(16)) register_p (.clk(clk), .word(p_638), .enable(finish), .clear(refuse), .q(p_out));
endmodule

// One of gates 620, 622, 624: passes all six coefficients while it is open, otherwise six times 0.
module coefficient_gate (
    input wire open,
    input wire signed [15:0] j,
    input wire signed [15:0] k,
    input wire signed [15:0] l,
    input wire signed [15:0] m,
    input wire signed [15:0] n,
    input wire signed [15:0] p,
    output wire signed [15:0] j_passed,
    output wire signed [15:0] k_passed,
    output wire signed [15:0] l_passed,
    output wire signed [15:0] m_passed,
    output wire signed [15:0] n_passed,
    output wire signed [15:0] p_passed
);
    word_gate #(.WIDTH(16)) gate_j (.open(open), .word(j), .passed(j_passed));
    word_gate #(.WIDTH(16)) gate_k (.open(open), .word(k), .passed(k_passed));
    word_gate #(.WIDTH(16)) gate_l (.open(open), .word(l), .passed(l_passed));
    word_gate #(.WIDTH(16)) gate_m (.open(open), .word(m), .passed(m_passed));
    word_gate #(.WIDTH(16)) gate_n (.open(open), .word(n), .passed(n_passed));
    word_gate #(.WIDTH(16)) gate_p (.open(open), .word(p), .passed(p_passed));
endmodule
