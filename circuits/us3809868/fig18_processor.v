`default_nettype none

// Computer control of US 3,809,868, FIG. 18: a computer writes words into registers, and starts the strokes that they are.
//
//   550, 584 --> computer 552 ==bus==> registers 556 to 566 in 554 --> generator 568 --> X(t), Y(t) --> display 570
//                             ==bus==> command --> start, stop ---------^
//
// Outside: keyboard 550, the disk or tape readers 584, display 570, and computer 552, a PDP-11, which is a program here
// (library `stepwright::host`, docs/host.md).
//
// The bus: `write` for one tick, with `address` and `data`. Status is there in every tick.
//
//   address  word
//   0 to 3   registers 556 (J), 558 (K), 560 (L), 562 (M), in two's complement
//   4, 5     registers 564 (X0), 566 (Y0)
//   6        the command: bit 0 start, bit 1 stop, bits 2 and 3 quarters less one, bit 4 without a mark
//   7        nothing; a write to it sets `error`
//   status   bit 15 error, 11 busy, 7 done since the last start, 4 to 1 as in the command
//
// A start takes bits 2 to 4 with it, and draws what the registers hold. A command with the stop bit stops the stroke
// where it is, with `busy` and its mark; the next command without it lets the stroke go on.
//
// From the text: what is on the bus ("start and stop information as well"), the six registers, and that transformations
// may be in 554: processor 366 of FIG. 11 stands there, and its controls are not on the bus. Chosen:
// - addresses and bits. Error, busy and done have the places that PDP-11 peripherals give them (paper tape reader
//   PC11), where a program tests them best;
// - the text has registers whose words stand at the generator's inputs during the stroke ("may be any of the designs",
//   and FIG. 4 needs them). So a write to a register while `busy` is refused;
// - generator 568 is that of FIG. 9, which has an input for its clock to be stopped.
//
// `busy` is high from the tick after a start to the end, `done` for one tick after that. `error` stays until the next
// start that is accepted:
// - a write to address 7, to a register while busy, a start while busy: the write has no effect, a stroke goes on;
// - 366 or the generator refuses the stroke (docs/system.md): nothing is drawn, `done` follows;
// - X or Y carried beyond 16 bits: told at the end, the mark is off from there on.
(* WIDTH_min = 1, WIDTH_max = 16, ENTRIES_min = 2, ENTRIES_max = 4096, ENTRY_WIDTH_min = 1, ENTRY_WIDTH_max = 16,
   GUARD_min = 0, GUARD_max = 3 *)
module fig18_processor #(
    parameter WIDTH = 12,           // these as in fig09_function_generator
    parameter ENTRIES = 128,
    parameter ENTRY_WIDTH = 6,
    parameter GUARD = 0
) (
    input wire clk,
    input wire write,
    input wire [2:0] address,
    input wire [15:0] data,
    input wire [4:0] control_382,   // these as in transformation_processor_366
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
    output wire [15:0] status,
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
    // The bus: which word is written, and whether it is accepted.
    wire [7:0] lines;
    wire idle, command, go, begun, at_register, refused_word, refused_start, unused_7;
    decoder #(.LINES(8)) decoder_address (.code(address), .lines(lines));
    and and_command (command, write, lines[6]);
    and and_go (go, command, data[0]);
    and and_begun (begun, go, idle);
    or or_at_register (at_register, lines[0], lines[1], lines[2], lines[3], lines[4], lines[5]);
    and and_refused_word (refused_word, write, at_register, busy);
    and and_refused_start (refused_start, go, busy);
    and and_unused_7 (unused_7, write, lines[7]);

    // The command.
    wire stopped, blank;
    wire [1:0] quarters_less_1;
    register #(.WIDTH(1)) register_stop (.clk(clk), .word(data[1]), .enable(command), .clear(1'b0), .q(stopped));
    register #(.WIDTH(2)) register_quarters (
        .clk(clk), .word(data[3:2]), .enable(begun), .clear(1'b0), .q(quarters_less_1)
    );
    register #(.WIDTH(1)) register_blank (.clk(clk), .word(data[4]), .enable(begun), .clear(1'b0), .q(blank));

    // 554: the registers and the transformations.
    wire load, finished_554, error_554;
    wire signed [15:0] j, k, l, m, x0, y0;
    and and_load (load, write, idle);
    register_processor_554 processor_554 (
        .clk(clk), .load(load), .lines(lines[5:0]), .data(data), .start(begun), .control_382(control_382),
        .control_450(control_450), .control_452(control_452), .control_454(control_454), .control_456(control_456),
        .control_458(control_458), .control_460(control_460), .control_462(control_462), .control_464(control_464),
        .angle_410(angle_410), .factor_471(factor_471), .offset_x_488(offset_x_488), .offset_y_490(offset_y_490),
        .j(j), .k(k), .l(l), .m(m), .x0(x0), .y0(y0), .finished(finished_554), .error(error_554)
    );

    // 568: the generator.
    wire right_554, start_568, busy_568, stop_568, error_568;
    wire one_quarter, odd, four_quarters;
    not not_error_554 (right_554, error_554);
    and and_start_568 (start_568, finished_554, right_554);
    not not_one (one_quarter, quarters_less_1[0]);
    xor xor_two (odd, quarters_less_1[1], quarters_less_1[0]);
    and and_four (four_quarters, quarters_less_1[1], quarters_less_1[0]);
    incremental_generator #(
        .WIDTH(WIDTH), .ENTRIES(ENTRIES), .ENTRY_WIDTH(ENTRY_WIDTH), .GUARD(GUARD)
    ) generator_568 (
        .clk(clk), .start(start_568), .j(j), .k(k), .l(l), .m(m), .x0(x0), .y0(y0),
        .quarters({four_quarters, odd, one_quarter}),
        .hold(1'b0), .inhibit(stopped), .fast(1'b0), .x(x), .y(y),
        .up_304(up_304), .down_306(down_306), .up_314(up_314), .down_316(down_316),
        .pulse_290(), .pulse_292(), .started(), .busy(busy_568), .done(stop_568), .error(error_568)
    );
    wire right_568, not_blank;
    not not_error_568 (right_568, error_568);
    not not_blank_568 (not_blank, blank);
    and and_mark (mark, busy_568, right_568, not_blank);

    // The end, and the status.
    wire failed_554, failed_568, wrong, finished, done_since;
    and and_failed_554 (failed_554, finished_554, error_554);
    and and_failed_568 (failed_568, stop_568, error_568);
    or or_wrong (wrong, unused_7, refused_word, refused_start, failed_554, failed_568);
    or or_finished (finished, failed_554, stop_568);
    trigger trigger_busy (.clk(clk), .set(begun), .reset(finished), .q(busy), .q_inverse(idle));
    trigger trigger_done (.clk(clk), .set(finished), .reset(begun), .q(done_since), .q_inverse());
    trigger trigger_error (.clk(clk), .set(wrong), .reset(begun), .q(error), .q_inverse());
    delay_element #(.DELAY(1)) delay_done (.clk(clk), .pulse_in(finished), .pulse_out(done), .active());
    assign status = {error, 3'b000, busy, 3'b000, done_since, 2'b00, blank, quarters_less_1, stopped, 1'b0};
endmodule

// Processor 554 of US 3,809,868, FIG. 18: registers 556 to 566 on the bus, and the transformations that may sit behind
// them, processor 366 of FIG. 11.
//
// The registers must stay as they are from `start` on until the generator has ended; `finished` comes ten ticks after
// `start`, with `error` when 366 has a word that does not fit.
module register_processor_554 (
    input wire clk,
    input wire load,                // the bus holds a word that is accepted
    input wire [5:0] lines,         // for which register
    input wire [15:0] data,
    input wire start,
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
    output wire signed [15:0] j,
    output wire signed [15:0] k,
    output wire signed [15:0] l,
    output wire signed [15:0] m,
    output wire signed [15:0] x0,
    output wire signed [15:0] y0,
    output wire finished,
    output wire error
);
    wire load_556, load_558, load_560, load_562, load_564, load_566;
    and and_556 (load_556, load, lines[0]);
    and and_558 (load_558, load, lines[1]);
    and and_560 (load_560, load, lines[2]);
    and and_562 (load_562, load, lines[3]);
    and and_564 (load_564, load, lines[4]);
    and and_566 (load_566, load, lines[5]);

    wire signed [15:0] j_556, k_558, l_560, m_562, x0_564, y0_566;
    register #(.WIDTH(16)) register_556 (.clk(clk), .word(data), .enable(load_556), .clear(1'b0), .q(j_556));
    register #(.WIDTH(16)) register_558 (.clk(clk), .word(data), .enable(load_558), .clear(1'b0), .q(k_558));
    register #(.WIDTH(16)) register_560 (.clk(clk), .word(data), .enable(load_560), .clear(1'b0), .q(l_560));
    register #(.WIDTH(16)) register_562 (.clk(clk), .word(data), .enable(load_562), .clear(1'b0), .q(m_562));
    register #(.WIDTH(16)) register_564 (.clk(clk), .word(data), .enable(load_564), .clear(1'b0), .q(x0_564));
    register #(.WIDTH(16)) register_566 (.clk(clk), .word(data), .enable(load_566), .clear(1'b0), .q(y0_566));

    wire error_366, error_380;
    transformation_processor_366 processor_366 (
        .clk(clk), .start(start), .control_382(control_382),
        .control_450(control_450), .control_452(control_452), .control_454(control_454), .control_456(control_456),
        .control_458(control_458), .control_460(control_460), .control_462(control_462), .control_464(control_464),
        .angle_410(angle_410), .factor_471(factor_471), .offset_x_488(offset_x_488), .offset_y_490(offset_y_490),
        .j(j_556), .k(k_558), .l(l_560), .m(m_562), .x0(x0_564), .y0(y0_566),
        .j_out(j), .k_out(k), .l_out(l), .m_out(m), .x0_out(x0), .y0_out(y0),
        .finished(finished), .error(error_366), .error_380(error_380)
    );
    or or_error (error, error_366, error_380);
endmodule
