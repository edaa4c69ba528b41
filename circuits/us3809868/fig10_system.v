`default_nettype none

// The system of US 3,809,868 with the control of FIG. 10 as a whole: points and slopes in, a tool moved by stepping motors
// out. Data converter 14 (FIG. 1, with FIG. 3 and 5 to 8 inside) finds J, K, L, M; control_10 holds the function generator 16
// and the control of its velocity (MODE, see fig10_tool_control); incremental device 328 is X motor 328a, Y motor 328b and
// tool 328c, which they move.
//
// Claims: 16, the rate of the elemental signals is controlled (MODE 1, 2, 3); 17, the clock is inhibited for an interval
// after each of them (MODE 4); 18, a part is moved and its acceleration limited (MODE 2, or 3 as the alternative). The
// scenarios claim_16, claim_17 and claim_18 show them.
//
// From the text: FIG. 10 takes X and Y stepping motors "of a tool". Chosen: four-phase motors (see block stepping_motor),
// a step for each pulse; tool 328c has no block of its own, it is where its motors are: x_328c, y_328c. It is set to
// (X0, Y0) when the generator starts, as counters 318 and 320 are; how it gets there is not part of the figure. `start`,
// `busy`, `done` and `error` are those of data_converter_14.
(* WIDTH_min = 1, WIDTH_max = 16, ENTRIES_min = 2, ENTRIES_max = 4096, ENTRY_WIDTH_min = 1, ENTRY_WIDTH_max = 16,
   GUARD_min = 0, GUARD_max = 3, HALF_min = 2, HALF_max = 1024, MODE_min = 0, MODE_max = 4,
   WINDOW_min = 3, WINDOW_max = 16384, MIN_DELAY_min = 0, MIN_DELAY_max = 255,
   MAX_DELAY_min = 0, MAX_DELAY_max = 255, STEP_min = 1, STEP_max = 64, BLOCK_BITS_min = 0, BLOCK_BITS_max = 24,
   ENDS_min = 0, ENDS_max = 255, MIDDLE_min = 0, MIDDLE_max = 255, RAMP_min = 0, RAMP_max = 4096,
   BLOCKS_min = 1, BLOCKS_max = 4096 *)
module fig10_system #(
    parameter WIDTH = 12,         // these as in fig10_tool_control
    parameter ENTRIES = 128,
    parameter ENTRY_WIDTH = 6,
    parameter GUARD = 0,
    parameter HALF = 2,
    parameter MODE = 2,
    parameter WINDOW = 1000,
    parameter MIN_DELAY = 4,
    parameter MAX_DELAY = 120,
    parameter STEP = 1,
    parameter BLOCK_BITS = 4,
    parameter ENDS = 120,
    parameter MIDDLE = 20,
    parameter RAMP = 16,
    parameter BLOCKS = 82
) (
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
    input wire [7:0] delay,                     // modes 1 and 4
    input wire [15:0] reference_340,            // mode 2
    input wire preset_write,                    // mode 3
    input wire [7:0] preset_address,
    input wire [7:0] preset_word,
    output wire signed [15:0] j,
    output wire signed [15:0] k,
    output wire signed [15:0] l,
    output wire signed [15:0] m,
    output wire signed [15:0] x,
    output wire signed [15:0] y,
    output wire up_304,
    output wire down_306,
    output wire up_314,
    output wire down_316,
    output wire hold_345,
    output wire [3:0] windings_328a,
    output wire [3:0] windings_328b,
    output wire signed [15:0] x_328c,
    output wire signed [15:0] y_328c,
    output wire mark,
    output wire busy,
    output wire done,
    output wire error
);
    wire signed [15:0] x0_14, y0_14;
    wire [2:0] quarters_held;
    wire launch, started, done_16, error_16;
    data_converter_14 converter_14 (
        .clk(clk), .start(start), .case_number(case_number), .quarters(quarters),
        .x0(x0), .y0(y0), .x1(x1), .y1(y1), .x2(x2), .y2(y2), .x3(x3), .y3(y3), .s0(s0), .s1(s1), .s3(s3),
        .done_16(done_16), .error_16(error_16), .begun(), .j(j), .k(k), .l(l), .m(m),
        .x0_out(x0_14), .y0_out(y0_14), .quarters_held(quarters_held), .launch(launch),
        .busy(busy), .done(done), .error(error)
    );
    fig10_tool_control #(
        .WIDTH(WIDTH),
        .ENTRIES(ENTRIES),
        .ENTRY_WIDTH(ENTRY_WIDTH),
        .GUARD(GUARD),
        .HALF(HALF),
        .MODE(MODE),
        .WINDOW(WINDOW),
        .MIN_DELAY(MIN_DELAY),
        .MAX_DELAY(MAX_DELAY),
        .STEP(STEP),
        .BLOCK_BITS(BLOCK_BITS),
        .ENDS(ENDS),
        .MIDDLE(MIDDLE),
        .RAMP(RAMP),
        .BLOCKS(BLOCKS)
    ) control_10 (
        .clk(clk), .start(launch), .j(j), .k(k), .l(l), .m(m), .x0(x0_14), .y0(y0_14), .quarters(quarters_held),
        .delay(delay), .reference_340(reference_340),
        .preset_write(preset_write), .preset_address(preset_address), .preset_word(preset_word),
        .x(x), .y(y), .up_304(up_304), .down_306(down_306), .up_314(up_314), .down_316(down_316), .hold_345(hold_345),
        .started(started), .busy(mark), .done(done_16), .error(error_16)
    );

    // 328: the motors, and the tool where they are.
    stepping_motor #(.WIDTH(16)) motor_328a (
        .clk(clk), .preset(started), .preset_value(x0_14), .up(up_304), .down(down_306),
        .windings(windings_328a), .position(x_328c)
    );
    stepping_motor #(.WIDTH(16)) motor_328b (
        .clk(clk), .preset(started), .preset_value(y0_14), .up(up_314), .down(down_316),
        .windings(windings_328b), .position(y_328c)
    );
endmodule
