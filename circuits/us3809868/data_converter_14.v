`default_nettype none

// Data converter 14 of US 3,809,868, FIG. 1, with all five cases, and the sequence from a start to the end of a stroke
// that the systems built on it share.
//
// From the text: the converter may contain all five cases, one of which is selected by the operator. `case_number`, 1 to
// 5, selects it; an input that the case has no use for is ignored.
//
// Chosen: `start` (one tick, with all inputs valid in that tick) begins the conversion. `launch` is high for one tick when
// it has come to a good end: it starts the function generator, which gives `done_16` and `error_16` in turn. `busy` is
// high from the tick after the start to the end; a start meanwhile is ignored. `done` is high for one tick after that.
// `error` goes with it and stays until the next start: the case number is not 1 to 5, the data have no solution (see the
// converters), or the generator told an error.
module data_converter_14 (
    input wire clk,
    input wire start,
    input wire [2:0] case_number,
    input wire [2:0] quarters,
    input wire signed [15:0] x0,
    input wire signed [15:0] y0,
    input wire signed [15:0] x1,
    input wire signed [15:0] y1,
    input wire signed [15:0] x2,
    input wire signed [15:0] y2,
    input wire signed [15:0] x3,
    input wire signed [15:0] y3,
    (* fraction = 18 *) input wire signed [31:0] s0,
    (* fraction = 18 *) input wire signed [31:0] s1,
    (* fraction = 18 *) input wire signed [31:0] s3,
    input wire done_16,                         // of the function generator
    input wire error_16,
    output wire begun,                          // 1 in the tick of a start that is accepted
    output wire signed [15:0] j,
    output wire signed [15:0] k,
    output wire signed [15:0] l,
    output wire signed [15:0] m,
    output wire signed [15:0] x0_out,
    output wire signed [15:0] y0_out,
    output wire [2:0] quarters_held,
    output wire launch,
    output wire busy,
    output wire done,
    output wire error
);
    // The case: its line starts the converter at once, and selects its results until the next start.
    wire [7:0] lines;
    wire [7:0] lines_held;
    wire [2:0] case_held;
    wire idle;
    wire known_case;
    wire unknown_case;
    wire refused;
    decoder #(.LINES(8)) decoder_case (.code(case_number), .lines(lines));
    or or_known (known_case, lines[1], lines[2], lines[3], lines[4], lines[5]);
    not not_known (unknown_case, known_case);
    and and_begun (begun, start, idle, known_case);
    and and_refused (refused, start, idle, unknown_case);
    register #(.WIDTH(3)) register_case (.clk(clk), .word(case_number), .enable(begun), .clear(1'b0), .q(case_held));
    register #(.WIDTH(3)) register_quarters (
        .clk(clk), .word(quarters), .enable(begun), .clear(1'b0), .q(quarters_held)
    );
    decoder #(.LINES(8)) decoder_held (.code(case_held), .lines(lines_held));

    // The five cases.
    wire start_1;
    wire signed [15:0] j_1;
    wire signed [15:0] k_1;
    wire signed [15:0] l_1;
    wire signed [15:0] m_1;
    wire signed [15:0] x0_1;
    wire signed [15:0] y0_1;
    wire done_1;
    wire error_1;
    and and_start_1 (start_1, begun, lines[1]);
    fig03_case1 converter_case1 (
        .clk(clk), .start(start_1), .x0(x0), .y0(y0), .x1(x1), .y1(y1), .s0(s0), .s1(s1),
        .x0_out(x0_1), .y0_out(y0_1), .j(j_1), .k(k_1), .l(l_1), .m(m_1), .done(done_1), .error(error_1)
    );

    wire start_2;
    wire signed [15:0] j_2;
    wire signed [15:0] k_2;
    wire signed [15:0] l_2;
    wire signed [15:0] m_2;
    wire signed [15:0] x0_2;
    wire signed [15:0] y0_2;
    wire done_2;
    wire error_2;
    and and_start_2 (start_2, begun, lines[2]);
    fig05_case2 converter_case2 (
        .clk(clk), .start(start_2), .x0(x0), .y0(y0), .x1(x1), .y1(y1), .x3(x3), .y3(y3), .s0(s0),
        .x0_out(x0_2), .y0_out(y0_2), .j(j_2), .k(k_2), .l(l_2), .m(m_2), .done(done_2), .error(error_2)
    );

    wire start_3;
    wire signed [15:0] j_3;
    wire signed [15:0] k_3;
    wire signed [15:0] l_3;
    wire signed [15:0] m_3;
    wire signed [15:0] x0_3;
    wire signed [15:0] y0_3;
    wire done_3;
    wire error_3;
    and and_start_3 (start_3, begun, lines[3]);
    fig06_case3 converter_case3 (
        .clk(clk), .start(start_3), .x0(x0), .y0(y0), .x1(x1), .y1(y1), .x3(x3), .y3(y3), .s1(s1),
        .x0_out(x0_3), .y0_out(y0_3), .j(j_3), .k(k_3), .l(l_3), .m(m_3), .done(done_3), .error(error_3)
    );

    wire start_4;
    wire signed [15:0] j_4;
    wire signed [15:0] k_4;
    wire signed [15:0] l_4;
    wire signed [15:0] m_4;
    wire signed [15:0] x0_4;
    wire signed [15:0] y0_4;
    wire done_4;
    wire error_4;
    and and_start_4 (start_4, begun, lines[4]);
    fig07_case4 converter_case4 (
        .clk(clk), .start(start_4), .x0(x0), .y0(y0), .x1(x1), .y1(y1), .x3(x3), .y3(y3), .s3(s3),
        .x0_out(x0_4), .y0_out(y0_4), .j(j_4), .k(k_4), .l(l_4), .m(m_4), .done(done_4), .error(error_4)
    );

    wire start_5;
    wire signed [15:0] j_5;
    wire signed [15:0] k_5;
    wire signed [15:0] l_5;
    wire signed [15:0] m_5;
    wire signed [15:0] x0_5;
    wire signed [15:0] y0_5;
    wire done_5;
    wire error_5;
    and and_start_5 (start_5, begun, lines[5]);
    fig08_case5 converter_case5 (
        .clk(clk), .start(start_5), .x0(x0), .y0(y0), .x1(x1), .y1(y1), .x2(x2), .y2(y2),
        .x0_out(x0_5), .y0_out(y0_5), .j(j_5), .k(k_5), .l(l_5), .m(m_5), .done(done_5), .error(error_5)
    );

    wire [63:0] coefficients;
    wire [33:0] position_and_state;
    data_switch #(.WIDTH(64)) switch_coefficients (
        .lines(lines_held[5:1]),
        .a({j_1, k_1, l_1, m_1}),
        .b({j_2, k_2, l_2, m_2}),
        .c({j_3, k_3, l_3, m_3}),
        .d({j_4, k_4, l_4, m_4}),
        .e({j_5, k_5, l_5, m_5}),
        .word(coefficients)
    );
    data_switch #(.WIDTH(34)) switch_position (
        .lines(lines_held[5:1]),
        .a({x0_1, y0_1, done_1, error_1}),
        .b({x0_2, y0_2, done_2, error_2}),
        .c({x0_3, y0_3, done_3, error_3}),
        .d({x0_4, y0_4, done_4, error_4}),
        .e({x0_5, y0_5, done_5, error_5}),
        .word(position_and_state)
    );
    wire done_14;
    wire error_14;
    assign {j, k, l, m} = coefficients;
    assign {x0_out, y0_out, done_14, error_14} = position_and_state;

    // The end of the conversion: start the generator, or give up.
    wire done_before;
    wire was_not_done;
    wire good_14;
    wire converted;
    wire failed;
    delay_element #(.DELAY(1)) delay_converted (.clk(clk), .pulse_in(done_14), .pulse_out(done_before), .active());
    not not_done (was_not_done, done_before);
    not not_error (good_14, error_14);
    and and_converted (converted, done_14, was_not_done, busy);
    and and_launch (launch, converted, good_14);
    and and_failed (failed, converted, error_14);

    // The end.
    wire bad_end;
    wire wrong;
    wire finished;
    and and_bad_end (bad_end, done_16, error_16);
    or or_wrong (wrong, refused, failed, bad_end);
    or or_finished (finished, refused, failed, done_16);
    trigger trigger_busy (.clk(clk), .set(begun), .reset(finished), .q(busy), .q_inverse(idle));
    trigger trigger_error (.clk(clk), .set(wrong), .reset(begun), .q(error), .q_inverse());
    delay_element #(.DELAY(1)) delay_done (.clk(clk), .pulse_in(finished), .pulse_out(done), .active());
endmodule
