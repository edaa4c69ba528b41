`default_nettype none

// Processor 503 of US 3,809,868, FIG. 17, with the registers around it: everything between instruction memory 502 and
// function generator 512. FIG. 17 and FIG. 11 use it.
//
// How a character is drawn. Pointer 500 and counter 508 are where the present instruction stands; multiplexer 504 shows
// its five words. Decoder 505 says what it is:
// - a curve: gate 506 lets J, K, L, M into the registers 507, 508 goes five words on, and when 514 has scaled the
//   coefficients the generator starts. Its stop signal makes 509 and 510 store X(t) and Y(t), from where the next
//   stroke goes on;
// - a positioning move: gate 506 directs X and Y to 509 and 510, through 514, and 508 goes three words on;
// - the exit: 508 is reset, the character is done.
//
// Time: a curve takes 4 ticks besides those of its stroke, a move 4, start and exit 1 each.
//
// Chosen, where the patent is silent:
// - 504 does not lead every word of the memory to a switch: it is the sum of pointer and count, the memory's address;
// - the registers 509 and 510 have a switch of three inputs: (x0, y0) at the start, a position, X(t) and Y(t) at a stop;
// - positions are relative to (x0, y0), which is kept during the character: so a character can stand anywhere, and
//   each move takes away what the rounding of the strokes before has added up to;
// - between 514 and the registers the words may be transformed: FIG. 11 leads them through 366, FIG. 17 just leads them
//   back. A position, which is a vector from the origin, goes that way as K and M of a stroke without J and L: so it is
//   turned and mirrored as strokes are, and a character keeps together;
// - X and Y are scaled as well ("may also be directed through 514"): the glyphs are stored on one expanded scale;
// - x and y follow the generator during a stroke and show 509 and 510 otherwise;
// - the check of everything that may be wrong, see fig17_characters.
module character_processor (
    input wire clk,
    input wire start,                       // one tick, with x0, y0, scale_514
    input wire signed [15:0] x0,
    input wire signed [15:0] y0,
    (* fraction = 12 *) input wire signed [15:0] scale_514,
    input wire [15:0] pointer_500,          // pointer table 500, from the tick after begin_503 on
    input wire known_500,
    input wire [15:0] control_502,          // memory 502 at address_504
    input wire signed [15:0] word_1,
    input wire signed [15:0] word_2,
    input wire signed [15:0] word_3,
    input wire signed [15:0] word_4,
    input wire [2:0] count_502,             // how many of the five words are inside the memory
    input wire done_366,                    // what 514 gave has been transformed, see below; FIG. 17: start_366
    input wire error_366,
    input wire signed [15:0] k_366,         // K and M that came of a position
    input wire signed [15:0] m_366,
    input wire busy_512,                    // generator 512
    input wire stop_512,
    input wire error_512,
    input wire signed [15:0] x_512,
    input wire signed [15:0] y_512,
    output wire begin_503,                  // a start is accepted
    output wire [15:0] address_504,
    output wire start_366,                  // j, k, l, m stand; high for one tick
    output wire start_512,                  // with the stroke that came of them, x_509, y_510
    output wire signed [15:0] j,
    output wire signed [15:0] k,
    output wire signed [15:0] l,
    output wire signed [15:0] m,
    output wire signed [15:0] x_509,
    output wire signed [15:0] y_510,
    output wire signed [15:0] x,            // where the pen is
    output wire signed [15:0] y,
    output wire mark,                       // a stroke is being drawn
    output wire busy,
    output wire done,                       // one tick after the end
    output wire error
);
    // Clocking of the processor: one instruction after the other, each stroke until its stop signal.
    wire curve_505, position_505, exit_505;
    wire fetch, start_514, add, place, drawing, store, fault;
    wire scaled_514, too_large_514, too_large, beyond_509, beyond_510, beyond;
    or or_beyond (beyond, beyond_509, beyond_510);
    or or_too_large (too_large, too_large_514, error_366);
    stroke_sequencer sequencer_503 (
        .clk(clk),
        .start(start),
        .known(known_500),
        .curve(curve_505),
        .position(position_505),
        .exit(exit_505),
        .scaled(done_366),
        .too_large(too_large),
        .beyond(beyond),
        .stop(stop_512),
        .failed(error_512),
        .accepted(begin_503),
        .fetch(fetch),
        .start_514(start_514),
        .add(add),
        .place(place),
        .start_512(start_512),
        .drawing(drawing),
        .store(store),
        .busy(busy),
        .done(done),
        .fault(fault)
    );

    // 504 and 508: which five words. 505: what they are.
    wire curve_506, position_506;
    wire [15:0] count_508;
    wire exit_508, clear_508;
    instruction_multiplexer multiplexer_504 (.pointer(pointer_500), .count(count_508), .address(address_504));
    instruction_decoder decoder_505 (
        .control(control_502), .count(count_502), .curve(curve_505), .position(position_505), .exit(exit_505)
    );
    and and_506_curve (curve_506, fetch, curve_505);
    and and_506_position (position_506, fetch, position_505);
    and and_exit_508 (exit_508, fetch, exit_505);
    or or_clear_508 (clear_508, begin_503, exit_508);
    instruction_counter counter_508 (
        .clk(clk), .clear(clear_508), .curve(curve_506), .position(position_506), .count(count_508)
    );

    // Gate 506: the words of a curve to 507, those of a position to 514 and so to 509 and 510.
    wire other_506;
    not not_506 (other_506, position_506);
    wire signed [15:0] j_507, k_507, l_507, m_507;
    register #(.WIDTH(16)) register_507_j (.clk(clk), .word(word_1), .enable(curve_506), .clear(1'b0), .q(j_507));
    register #(.WIDTH(16)) register_507_k (.clk(clk), .word(word_2), .enable(curve_506), .clear(1'b0), .q(k_507));
    register #(.WIDTH(16)) register_507_l (.clk(clk), .word(word_3), .enable(curve_506), .clear(1'b0), .q(l_507));
    register #(.WIDTH(16)) register_507_m (.clk(clk), .word(word_4), .enable(curve_506), .clear(1'b0), .q(m_507));
    wire signed [15:0] j_or_0, k_or_x, l_or_0, m_or_y;
    multiplexer #(.WIDTH(16)) gate_506_j (.a(other_506), .b(1'b0), .x1(j_507), .x2(16'd0), .z(j_or_0));
    multiplexer #(.WIDTH(16)) gate_506_x (.a(other_506), .b(position_506), .x1(k_507), .x2(word_1), .z(k_or_x));
    multiplexer #(.WIDTH(16)) gate_506_l (.a(other_506), .b(1'b0), .x1(l_507), .x2(16'd0), .z(l_or_0));
    multiplexer #(.WIDTH(16)) gate_506_y (.a(other_506), .b(position_506), .x1(m_507), .x2(word_2), .z(m_or_y));

    // 514: the reduction, by the factor that came with the start.
    (* fraction = 12 *) wire signed [15:0] factor_514;
    register #(.WIDTH(16)) register_514 (
        .clk(clk), .word(scale_514), .enable(begin_503), .clear(1'b0), .q(factor_514)
    );
    // Scaling circuit 514, "such as that indicated in FIG. 14".
    fig14_scaling scaling_514 (
        .clk(clk),
        .start(start_514),
        .factor_471(factor_514),
        .j(j_or_0),
        .k(k_or_x),
        .l(l_or_0),
        .m(m_or_y),
        .j_out(j),
        .k_out(k),
        .l_out(l),
        .m_out(m),
        .done(scaled_514),
        .error(too_large_514)
    );
    wire before_514, new_514;
    delay_element #(.DELAY(1)) delay_514 (.clk(clk), .pulse_in(scaled_514), .pulse_out(before_514), .active());
    not not_before_514 (new_514, before_514);
    and and_start_366 (start_366, scaled_514, new_514);

    // 509 and 510: X0 and Y0, from the start, from a position, or from where the last stroke ended.
    wire signed [15:0] origin_x, origin_y, position_x, position_y, new_509, new_510;
    wire load_509_510;
    register #(.WIDTH(16)) register_origin_x (
        .clk(clk), .word(x0), .enable(begin_503), .clear(1'b0), .q(origin_x)
    );
    register #(.WIDTH(16)) register_origin_y (
        .clk(clk), .word(y0), .enable(begin_503), .clear(1'b0), .q(origin_y)
    );
    summer #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(16)) summer_origin_x (
        .clk(clk), .strobe(add), .a(origin_x), .b(k_366), .sum(position_x), .overflow(beyond_509)
    );
    summer #(.A_WIDTH(16), .B_WIDTH(16), .WIDTH(16)) summer_origin_y (
        .clk(clk), .strobe(add), .a(origin_y), .b(m_366), .sum(position_y), .overflow(beyond_510)
    );
    or or_load_509_510 (load_509_510, begin_503, place, store);
    data_switch #(.WIDTH(16)) switch_509 (
        .lines({2'b00, store, place, begin_503}),
        .a(x0), .b(position_x), .c(x_512), .d(16'd0), .e(16'd0), .word(new_509)
    );
    data_switch #(.WIDTH(16)) switch_510 (
        .lines({2'b00, store, place, begin_503}),
        .a(y0), .b(position_y), .c(y_512), .d(16'd0), .e(16'd0), .word(new_510)
    );
    register #(.WIDTH(16)) register_509 (
        .clk(clk), .word(new_509), .enable(load_509_510), .clear(1'b0), .q(x_509)
    );
    register #(.WIDTH(16)) register_510 (
        .clk(clk), .word(new_510), .enable(load_509_510), .clear(1'b0), .q(y_510)
    );

    // The pen and its mark. A stroke that has gone wrong is not shown.
    wire fine_512, follow_512, rest_512;
    not not_error_512 (fine_512, error_512);
    and and_follow_512 (follow_512, drawing, fine_512);
    not not_follow_512 (rest_512, follow_512);
    and and_mark (mark, follow_512, busy_512);
    multiplexer #(.WIDTH(16)) multiplexer_x (.a(follow_512), .b(rest_512), .x1(x_512), .x2(x_509), .z(x));
    multiplexer #(.WIDTH(16)) multiplexer_y (.a(follow_512), .b(rest_512), .x1(y_512), .x2(y_510), .z(y));

    // The error flip-flop.
    wire refused, wrong;
    and and_refused (refused, start, busy);
    or or_wrong (wrong, fault, refused);
    trigger trigger_error (.clk(clk), .set(wrong), .reset(begin_503), .q(error), .q_inverse());
endmodule
