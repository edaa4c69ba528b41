`default_nettype none

// FIG. 11 of US 3,809,868 up to the function generator: strokes by points and slopes, or characters by their code, come
// out transformed, as J, K, L, M, X0, Y0 and a start. fig11_system, fig11_display and fig11_tool put generator 370 and
// clipping behind it.
//
//   points, slopes --> 350 (352 to 360, 362 under 364) --> 366 (368 under 382; 372 to 380) --> 370
//   code ------------> 400 (402, 404, 406) ------------>-'
//
// case_364: 1 to 5 for cases I to V, 6 for a character at (x0, y0); an input that the selected way has no use for is
// ignored. docs/system.md has a table of all controls.
//
// A stroke is converted (350), transformed (366) and drawn once. A character's strokes pass 366 one after another, each
// when the one before has stopped. Offset 380 moves the character's origin, and with it all that follows.
//
// Chosen, where the patent is silent:
// - `start` (one tick, with all inputs valid in that tick) begins; all inputs are kept. `busy` is high from the tick
//   after it to the end; a start meanwhile is ignored. `done` is high for one tick after the end;
// - `error` goes with `done` and stays until the next start: case_364 is none of 1 to 6, the data have no solution,
//   controls of FIG. 13 that make no sense, a word that leaves its 16 bits, an unknown character, error_384 (the window
//   makes no sense), or the generator refuses a coefficient or `quarters`: then nothing is drawn. X or Y carried beyond
//   16 bits in the generator is told at the end, and the mark is off from there on;
// - a character's strokes are of one quarter, whatever `quarters` is;
// - x and y follow the generator, during and after a character the place of the pen (x, y of 400).
module fig11_strokes #(
    parameter IMAGE = "letters"     // of 404
) (
    input wire clk,
    input wire start,
    input wire [2:0] case_364,
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
    input wire [2:0] quarters,
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
    input wire [7:0] code_449,
    (* fraction = 12 *) input wire signed [15:0] scale_514,
    input wire error_384,                   // of clipping 384, from the tick after the start on
    input wire busy_370,                    // generator 370 draws
    input wire stop_370,
    input wire error_370,
    input wire signed [15:0] x_370,
    input wire signed [15:0] y_370,
    output wire begun,                      // 1 in the tick of a start that is accepted
    output wire start_370,                  // with j to m, x0_370, y0_370, quarters_370
    output wire signed [15:0] j,
    output wire signed [15:0] k,
    output wire signed [15:0] l,
    output wire signed [15:0] m,
    output wire signed [15:0] x0_370,
    output wire signed [15:0] y0_370,
    output wire [2:0] quarters_370,
    output wire signed [15:0] x,
    output wire signed [15:0] y,
    output wire mark,                       // a stroke is being drawn, before any clipping
    output wire busy,
    output wire done,
    output wire error
);
    // The start. Control 364 selects a converter, or 400.
    wire idle;
    wire [7:0] lines, lines_364;
    wire [2:0] held_364, held_quarters;
    wire stroke, character, known_364, unknown_364, other_364;
    and and_begun (begun, start, idle);
    decoder #(.LINES(8)) decoder_364 (.code(case_364), .lines(lines));
    register #(.WIDTH(3)) register_364 (.clk(clk), .word(case_364), .enable(begun), .clear(1'b0), .q(held_364));
    decoder #(.LINES(8)) decoder_held_364 (.code(held_364), .lines(lines_364));
    or or_stroke (stroke, lines_364[1], lines_364[2], lines_364[3], lines_364[4], lines_364[5]);
    assign character = lines_364[6];
    or or_known (known_364, stroke, character);
    not not_known (unknown_364, known_364);
    not not_stroke (other_364, stroke);

    // All other inputs are kept (350 keeps its own).
    wire signed [15:0] held_x0, held_y0, held_471, held_488, held_490;
    wire [15:0] held_410;
    wire [4:0] held_382;
    wire [7:0] held_450_464;
    register #(.WIDTH(16)) register_x0 (.clk(clk), .word(x0), .enable(begun), .clear(1'b0), .q(held_x0));
    register #(.WIDTH(16)) register_y0 (.clk(clk), .word(y0), .enable(begun), .clear(1'b0), .q(held_y0));
    register #(.WIDTH(3)) register_quarters (
        .clk(clk), .word(quarters), .enable(begun), .clear(1'b0), .q(held_quarters)
    );
    register #(.WIDTH(5)) register_382 (.clk(clk), .word(control_382), .enable(begun), .clear(1'b0), .q(held_382));
    register #(.WIDTH(8)) register_450_464 (
        .clk(clk),
        .word({
            control_464, control_462, control_460, control_458, control_456, control_454, control_452, control_450
        }),
        .enable(begun),
        .clear(1'b0),
        .q(held_450_464)
    );
    register #(.WIDTH(16)) register_410 (.clk(clk), .word(angle_410), .enable(begun), .clear(1'b0), .q(held_410));
    register #(.WIDTH(16)) register_471 (.clk(clk), .word(factor_471), .enable(begun), .clear(1'b0), .q(held_471));
    register #(.WIDTH(16)) register_488 (.clk(clk), .word(offset_x_488), .enable(begun), .clear(1'b0), .q(held_488));
    register #(.WIDTH(16)) register_490 (.clk(clk), .word(offset_y_490), .enable(begun), .clear(1'b0), .q(held_490));

    // 350: the conversion.
    wire signed [15:0] j_362, k_362, l_362, m_362, x0_362, y0_362;
    wire done_350, error_350, before_350, new_350, converted;
    data_converter_350 converter_350 (
        .clk(clk), .begin_350(begun), .lines(lines[5:1]), .lines_held(lines_364[5:1]),
        .x0(x0), .y0(y0), .x1(x1), .y1(y1), .x2(x2), .y2(y2), .x3(x3), .y3(y3), .s0(s0), .s1(s1), .s3(s3),
        .x0_out(x0_362), .y0_out(y0_362), .j(j_362), .k(k_362), .l(l_362), .m(m_362),
        .done(done_350), .error(error_350)
    );
    delay_element #(.DELAY(1)) delay_350 (.clk(clk), .pulse_in(done_350), .pulse_out(before_350), .active());
    not not_before_350 (new_350, before_350);
    and and_converted (converted, done_350, new_350, busy);

    // What may be wrong before anything is drawn is judged when a conversion is done; without one, two ticks after the
    // start, when 380 is.
    wire two_later, looked, judged, error_380, wrong_before, right_before, failed_before;
    wire stroke_366, start_400;
    delay_element #(.DELAY(2)) delay_begun (.clk(clk), .pulse_in(begun), .pulse_out(two_later), .active());
    and and_looked (looked, two_later, other_364);
    or or_judged (judged, converted, looked);
    or or_wrong_before (wrong_before, unknown_364, error_350, error_380, error_384);
    not not_wrong_before (right_before, wrong_before);
    and and_failed_before (failed_before, judged, wrong_before);
    and and_stroke_366 (stroke_366, judged, right_before, stroke);
    and and_start_400 (start_400, judged, right_before, character);

    // 366: what goes in comes from 350, or from 400.
    wire start_366, character_366, finished_366, error_366, right_366;
    wire signed [15:0] j_400, k_400, l_400, m_400, x0_366, y0_366;
    wire [63:0] stroke_in_366;
    wire [31:0] point_in_366;
    or or_start_366 (start_366, stroke_366, character_366);
    multiplexer #(.WIDTH(64)) multiplexer_stroke_366 (
        .a(stroke), .b(character), .x1({j_362, k_362, l_362, m_362}), .x2({j_400, k_400, l_400, m_400}),
        .z(stroke_in_366)
    );
    multiplexer #(.WIDTH(32)) multiplexer_point_366 (
        .a(stroke), .b(character), .x1({x0_362, y0_362}), .x2({held_x0, held_y0}), .z(point_in_366)
    );
    transformation_processor_366 processor_366 (
        .clk(clk), .start(start_366), .control_382(held_382),
        .control_450(held_450_464[0]), .control_452(held_450_464[1]), .control_454(held_450_464[2]),
        .control_456(held_450_464[3]), .control_458(held_450_464[4]), .control_460(held_450_464[5]),
        .control_462(held_450_464[6]), .control_464(held_450_464[7]),
        .angle_410(held_410), .factor_471(held_471), .offset_x_488(held_488), .offset_y_490(held_490),
        .j(stroke_in_366[63:48]), .k(stroke_in_366[47:32]), .l(stroke_in_366[31:16]), .m(stroke_in_366[15:0]),
        .x0(point_in_366[31:16]), .y0(point_in_366[15:0]),
        .j_out(j), .k_out(k), .l_out(l), .m_out(m), .x0_out(x0_366), .y0_out(y0_366),
        .finished(finished_366), .error(error_366), .error_380(error_380)
    );

    // 400: characters.
    wire start_370_400, done_400, error_400, mark_400;
    wire signed [15:0] x_509, y_510, x_400, y_400;
    character_store_400 #(.IMAGE(IMAGE)) processor_400 (
        .clk(clk), .load(begun), .code_449(code_449), .scale_514(scale_514),
        .start(start_400), .x0(x0_366), .y0(y0_366),
        .done_366(finished_366), .error_366(error_366), .k_366(k), .m_366(m),
        .busy_370(busy_370), .stop_370(stop_370), .error_370(error_370), .x_370(x_370), .y_370(y_370),
        .start_366(character_366), .j(j_400), .k(k_400), .l(l_400), .m(m_400),
        .start_370(start_370_400), .x_509(x_509), .y_510(y_510),
        .x(x_400), .y(y_400), .mark(mark_400), .done(done_400), .error(error_400)
    );

    // To the generator.
    wire stroke_370, failed_366;
    not not_error_366 (right_366, error_366);
    and and_stroke_370 (stroke_370, finished_366, right_366, stroke);
    and and_failed_366 (failed_366, finished_366, error_366, stroke);
    or or_start_370 (start_370, stroke_370, start_370_400);
    multiplexer #(.WIDTH(35)) multiplexer_370 (
        .a(stroke), .b(character), .x1({x0_366, y0_366, held_quarters}), .x2({x_509, y_510, 3'd1}),
        .z({x0_370, y0_370, quarters_370})
    );

    // The pen and its mark. A stroke that has gone wrong is not shown.
    wire no_character, right_370, mark_stroke;
    not not_character (no_character, character);
    not not_error_370 (right_370, error_370);
    and and_mark_stroke (mark_stroke, busy_370, right_370, stroke);
    or or_mark (mark, mark_stroke, mark_400);
    multiplexer #(.WIDTH(32)) multiplexer_pen (
        .a(no_character), .b(character), .x1({x_370, y_370}), .x2({x_400, y_400}), .z({x, y})
    );

    // The end.
    wire stopped, bad_stop, bad_400, wrong, finished;
    and and_stopped (stopped, stop_370, stroke, busy);
    and and_bad_stop (bad_stop, stopped, error_370);
    and and_bad_400 (bad_400, done_400, error_400);
    or or_wrong (wrong, failed_before, failed_366, bad_stop, bad_400);
    or or_finished (finished, failed_before, failed_366, stopped, done_400);
    trigger trigger_busy (.clk(clk), .set(begun), .reset(finished), .q(busy), .q_inverse(idle));
    trigger trigger_error (.clk(clk), .set(wrong), .reset(begun), .q(error), .q_inverse());
    delay_element #(.DELAY(1)) delay_done (.clk(clk), .pulse_in(finished), .pulse_out(done), .active());
endmodule

// Character and symbol processor 400 of US 3,809,868, FIG. 11: a code calls the strokes of a character from a memory,
// one after the other. It is FIG. 17 without its generator 512.
//
// What FIG. 11 and 17 call the same: 402, random access memory, is memory 449, which is written with the code of each
// character; 404, read only memory, is pointer table 500 and instruction memory 502; 406, the control, is processor
// 503 with all its registers (control_406; see character_processor, where the ports, too, are explained). Chosen, as
// the text leaves it open: the instruction sets are all in 404, whose image is a file (docs/characters.md).
//
// Each stroke goes out as start_366 with j to m, scaled by 514, and comes back transformed with done_366; then
// start_370 asks for it to be drawn from x_509, y_510, and stop_370 ends it.
module character_store_400 #(
    parameter IMAGE = "letters"     // name of the memory image
) (
    input wire clk,
    input wire load,                // takes code_449 and scale_514
    input wire [7:0] code_449,
    (* fraction = 12 *) input wire signed [15:0] scale_514,
    input wire start,               // a character begins at (x0, y0)
    input wire signed [15:0] x0,
    input wire signed [15:0] y0,
    input wire done_366,
    input wire error_366,
    input wire signed [15:0] k_366,
    input wire signed [15:0] m_366,
    input wire busy_370,
    input wire stop_370,
    input wire error_370,
    input wire signed [15:0] x_370,
    input wire signed [15:0] y_370,
    output wire start_366,
    output wire signed [15:0] j,
    output wire signed [15:0] k,
    output wire signed [15:0] l,
    output wire signed [15:0] m,
    output wire start_370,
    output wire signed [15:0] x_509,
    output wire signed [15:0] y_510,
    output wire signed [15:0] x,
    output wire signed [15:0] y,
    output wire mark,
    output wire done,
    output wire error
);
    wire [7:0] code_402;
    (* fraction = 12 *) wire signed [15:0] scale;
    register #(.WIDTH(8)) memory_402 (.clk(clk), .word(code_449), .enable(load), .clear(1'b0), .q(code_402));
    register #(.WIDTH(16)) register_scale (.clk(clk), .word(scale_514), .enable(load), .clear(1'b0), .q(scale));

    wire [15:0] pointer_500;
    wire known_500;
    wire [15:0] address_504, control_502;
    wire signed [15:0] word_1, word_2, word_3, word_4;
    wire [2:0] count_502;
    pointer_table #(.IMAGE(IMAGE)) pointers_404 (.code(code_402), .pointer(pointer_500), .known(known_500));
    instruction_memory #(.IMAGE(IMAGE)) instructions_404 (
        .address(address_504), .control(control_502),
        .word_1(word_1), .word_2(word_2), .word_3(word_3), .word_4(word_4), .count(count_502)
    );

    character_processor control_406 (
        .clk(clk),
        .start(start),
        .x0(x0),
        .y0(y0),
        .scale_514(scale),
        .pointer_500(pointer_500),
        .known_500(known_500),
        .control_502(control_502),
        .word_1(word_1),
        .word_2(word_2),
        .word_3(word_3),
        .word_4(word_4),
        .count_502(count_502),
        .done_366(done_366),
        .error_366(error_366),
        .k_366(k_366),
        .m_366(m_366),
        .busy_512(busy_370),
        .stop_512(stop_370),
        .error_512(error_370),
        .x_512(x_370),
        .y_512(y_370),
        .begin_503(),
        .address_504(address_504),
        .start_366(start_366),
        .start_512(start_370),
        .j(j),
        .k(k),
        .l(l),
        .m(m),
        .x_509(x_509),
        .y_510(y_510),
        .x(x),
        .y(y),
        .mark(mark),
        .busy(),
        .done(done),
        .error(error)
    );
endmodule
