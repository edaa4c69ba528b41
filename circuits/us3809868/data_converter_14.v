`default_nettype none

// Data converter 14 of US 3,809,868, FIG. 1, with all five cases, and the sequence from a start to the end of a stroke
// that the systems built on it share.
//
// From the text: the converter may contain all five cases, one of which is selected by the operator. `case_number`, 1 to
// 5, selects it; an input that the case has no use for is ignored. They stand in data_converter_350, whose numerals are
// those of FIG. 11.
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
    wire done_14;
    wire error_14;
    data_converter_350 cases (
        .clk(clk), .begin_350(begun), .lines(lines[5:1]), .lines_held(lines_held[5:1]),
        .x0(x0), .y0(y0), .x1(x1), .y1(y1), .x2(x2), .y2(y2), .x3(x3), .y3(y3), .s0(s0), .s1(s1), .s3(s3),
        .x0_out(x0_out), .y0_out(y0_out), .j(j), .k(k), .l(l), .m(m), .done(done_14), .error(error_14)
    );

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
