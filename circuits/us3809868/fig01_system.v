// FIG. 1 of US 3,809,868: the system. Points and slopes in; a data converter (14) finds J, K, L and M, the function
// generator (16, here that of FIG. 9 and 10) draws with them; pulses and counters out. One quarter ends exactly at
// (X1, Y1).
//
// From the text: converter 14 may contain all five cases, one of which is selected by the operator. `case_number`, 1 to
// 5, selects it; an input that the case has no use for is ignored. `mark` is the enable of blanking 36: the generator is
// at work.
//
// Where the numerals are: 14 and 16 are instances; input source 12 is the inputs; lines 18 and 20 are x and y. Display
// system 22 is outside: x and y go to digital-to-analog conversion 24 and so to CRT 26, scan converter 28 with television
// display 30, storage tube 32 and XY plotter 34, mark to 36, and the pulses to incremental plotter 38 and tool 40.
//
// Chosen: `start` (one tick, with all inputs valid in that tick) begins the conversion, the converter's `done` starts
// the generator in the tick in which it rises. `busy` is high from the tick after the start to the end; a start
// meanwhile is ignored. `done` is high for one tick after that. `error` goes with it and stays until the next start:
// the case number is not 1 to 5; the data have no solution (see the converters); or a coefficient is beyond 4095 or
// `quarters` not 1 to 4 (see FIG. 9). Then nothing is drawn. X or Y carried beyond 16 bits is told in the same way, at
// the end.
`default_nettype none

module fig01_system (
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
    output wire mark,
    output wire busy,
    output wire done,
    output wire error
);
    wire signed [15:0] x0_14;
    wire signed [15:0] y0_14;
    wire [2:0] quarters_held;
    wire begun;
    wire launch;
    wire done_16;
    wire error_16;
    data_converter_14 converter_14 (
        .clk(clk), .start(start), .case_number(case_number), .quarters(quarters),
        .x0(x0), .y0(y0), .x1(x1), .y1(y1), .x2(x2), .y2(y2), .x3(x3), .y3(y3), .s0(s0), .s1(s1), .s3(s3),
        .done_16(done_16), .error_16(error_16), .begun(begun), .j(j), .k(k), .l(l), .m(m),
        .x0_out(x0_14), .y0_out(y0_14), .quarters_held(quarters_held), .launch(launch),
        .busy(busy), .done(done), .error(error)
    );
    fig09_function_generator generator_16 (
        .clk(clk), .start(launch), .j(j), .k(k), .l(l), .m(m), .x0(x0_14), .y0(y0_14), .quarters(quarters_held),
        .x(x), .y(y), .up_304(up_304), .down_306(down_306), .up_314(up_314), .down_316(down_316),
        .busy(mark), .done(done_16), .error(error_16)
    );
endmodule
