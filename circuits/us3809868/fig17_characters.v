`default_nettype none

// Character generator of US 3,809,868, FIG. 17: a code calls the strokes of a character from a memory.
//
//   code_449 --> 449 --> 500 --> 502 --> processor 503 --> 512 --> X(t), Y(t)
//                                         |________________|  stop
//
// Start: `start` high for one tick with all other inputs. The character is drawn with its origin at (x0, y0), scaled by
// scale_514 (4096 is 1). `mark` is 1 while a stroke is drawn, 0 during positioning moves. `done` is high for one tick
// after the exit word; x, y then is the pen's place, the origin of the next character: it is exactly
// x0 + round(advance * scale), y0. A stroke of FIG. 9 takes just as long whatever its size.
//
// Memory: parameter IMAGE names a file of glyphs beside the circuit; `letters.glyphs` is shipped. docs/characters.md
// tells its format and the encoding of the codes.
//
// A positioning move sets X0 and Y0 at once, as the text has it: X and Y jump, and lines 304 to 316 carry no pulses for
// it. A tool that is moved by these lines alone has to be brought there in another way.
//
// Bad input. `error` goes high, stays until the next start that is accepted, and `done` follows at once: a code that
// the image does not have, an instruction with an undefined control word, one outside the memory or cut off by its end,
// a word that does not fit 16 bits when it is scaled, a position outside of the coordinates, a coefficient beyond the
// generator's range, a stroke that runs out of the 16 bits of X or Y (the mark goes off there). A start while `busy` is
// refused with `error`, and the character under way goes on unharmed.
//
// From the text: 449, 500, 502 to 510, 512, 514. Slips mended: "multiplexer 510" is 504, "generator 506" is 512. The
// rest of what was chosen stands in character_processor.
(* WIDTH_min = 1, WIDTH_max = 16, ENTRIES_min = 2, ENTRIES_max = 4096, ENTRY_WIDTH_min = 1, ENTRY_WIDTH_max = 16,
   GUARD_min = 0, GUARD_max = 3 *)
module fig17_characters #(
    parameter IMAGE = "letters",    // name of the memory image
    parameter WIDTH = 12,           // generator 512, see fig09_function_generator
    parameter ENTRIES = 128,
    parameter ENTRY_WIDTH = 6,
    parameter GUARD = 0
) (
    input wire clk,
    input wire start,
    input wire [7:0] code_449,
    input wire signed [15:0] x0,
    input wire signed [15:0] y0,
    (* fraction = 12 *) input wire signed [15:0] scale_514,
    output wire signed [15:0] x,
    output wire signed [15:0] y,
    output wire up_304,
    output wire down_306,
    output wire up_314,
    output wire down_316,
    output wire mark,
    output wire busy,
    output wire done,
    output wire error
);
    // 449: the code. 500: where its instruction set begins. 502: the instructions.
    wire begin_503;
    wire [7:0] code;
    wire [15:0] pointer_500;
    wire known_500;
    wire [15:0] address_504, control_502;
    wire signed [15:0] word_1, word_2, word_3, word_4;
    wire [2:0] count_502;
    register #(.WIDTH(8)) memory_449 (.clk(clk), .word(code_449), .enable(begin_503), .clear(1'b0), .q(code));
    pointer_table #(.IMAGE(IMAGE)) table_500 (.code(code), .pointer(pointer_500), .known(known_500));
    instruction_memory #(.IMAGE(IMAGE)) memory_502 (
        .address(address_504),
        .control(control_502),
        .word_1(word_1),
        .word_2(word_2),
        .word_3(word_3),
        .word_4(word_4),
        .count(count_502)
    );

    wire scaled, start_512, busy_512, stop_512, error_512;
    wire signed [15:0] j, k, l, m, x_509, y_510, x_512, y_512;
    character_processor processor_503 (
        .clk(clk),
        .start(start),
        .x0(x0),
        .y0(y0),
        .scale_514(scale_514),
        .pointer_500(pointer_500),
        .known_500(known_500),
        .control_502(control_502),
        .word_1(word_1),
        .word_2(word_2),
        .word_3(word_3),
        .word_4(word_4),
        .count_502(count_502),
        .done_366(scaled),
        .error_366(1'b0),
        .k_366(k),
        .m_366(m),
        .busy_512(busy_512),
        .stop_512(stop_512),
        .error_512(error_512),
        .x_512(x_512),
        .y_512(y_512),
        .begin_503(begin_503),
        .address_504(address_504),
        .start_366(scaled),
        .start_512(start_512),
        .j(j),
        .k(k),
        .l(l),
        .m(m),
        .x_509(x_509),
        .y_510(y_510),
        .x(x),
        .y(y),
        .mark(mark),
        .busy(busy),
        .done(done),
        .error(error)
    );

    fig09_function_generator #(
        .WIDTH(WIDTH),
        .ENTRIES(ENTRIES),
        .ENTRY_WIDTH(ENTRY_WIDTH),
        .GUARD(GUARD)
    ) generator_512 (
        .clk(clk),
        .start(start_512),
        .j(j),
        .k(k),
        .l(l),
        .m(m),
        .x0(x_509),
        .y0(y_510),
        .quarters(3'd1),
        .x(x_512),
        .y(y_512),
        .up_304(up_304),
        .down_306(down_306),
        .up_314(up_314),
        .down_316(down_316),
        .busy(busy_512),
        .done(stop_512),
        .error(error_512)
    );
endmodule
