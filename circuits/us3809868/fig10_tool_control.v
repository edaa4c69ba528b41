`default_nettype none

// Tool control of US 3,809,868, FIG. 10: the function generator with velocity and acceleration control 338 to 347.
//
// A delay runs after the trailing edge of each pulse, 341 for X and 342 for Y. A pulse that comes while the delay of
// its axis still runs holds clock 329 (gates 343, 344, 345): the pulse stays on until the delay is over. So the path
// is the same, pulse for pulse, and only time is stretched; two trailing edges on one axis are never closer than the
// delay and half a clock, interval + HALF ticks. A tick is one of a master oscillator; half a clock is HALF of them.
//
// MODE says where the interval comes from:
//   0  no control: no delay
//   1  constant: input `delay`
//   2  as drawn: analyzer 338 measures the acceleration of the pulses, 339 compares it with reference 340, and every
//      WINDOW ticks the interval grows when it is above and shrinks when it is below. It starts long (MAX_DELAY).
//   3  the alternative: counter 346 counts the way travelled and addresses memory 347, which gives the interval. The
//      memory starts as a trapezoid of speed (see block presettable_memory) and is preset through the inputs preset_*.
//   4  claim 17: input `delay`, but the clock is inhibited for that interval after each pulse, whatever comes next.
//      The claim contradicts the description, which holds only a pulse that comes too early; both are here.
//
// From the text: every block with a numeral. Motors 328a and 328b and tool 328c are in fig10_system, behind the lines.
// Chosen: all numbers; how 338 is wired (see analyzer_338); that 341 and 342 share one interval, held by
// regulator_341_342; that 343 and 344 also act in the second half of the clock, because
// otherwise the pulses of multiplier 327 would escape them. Erratum followed: the pulses "from multipliers 325 and
// 329" are those of 325 and 327.
(* WIDTH_min = 1, WIDTH_max = 16, ENTRIES_min = 2, ENTRIES_max = 4096, ENTRY_WIDTH_min = 1, ENTRY_WIDTH_max = 16,
   GUARD_min = 0, GUARD_max = 3, HALF_min = 2, HALF_max = 1024, MODE_min = 0, MODE_max = 4,
   WINDOW_min = 3, WINDOW_max = 16384, MIN_DELAY_min = 0, MIN_DELAY_max = 255,
   MAX_DELAY_min = 0, MAX_DELAY_max = 255, STEP_min = 1, STEP_max = 64, BLOCK_BITS_min = 0, BLOCK_BITS_max = 24,
   ENDS_min = 0, ENDS_max = 255, MIDDLE_min = 0, MIDDLE_max = 255, RAMP_min = 0, RAMP_max = 4096,
   BLOCKS_min = 1, BLOCKS_max = 4096 *)
module fig10_tool_control #(
    parameter WIDTH = 12,         // as in incremental_generator
    parameter ENTRIES = 128,
    parameter ENTRY_WIDTH = 6,
    parameter GUARD = 0,
    parameter HALF = 2,           // ticks of half a clock
    parameter MODE = 2,           // 0 to 4, see above
    parameter WINDOW = 1000,      // 338: its time, 2^n ticks with the n for which that is just WINDOW or more; 339: how
                                  // often the interval changes. At most 16384
    parameter MIN_DELAY = 4,      // 339: limits and step of the interval
    parameter MAX_DELAY = 120,
    parameter STEP = 1,
    parameter BLOCK_BITS = 4,     // 346: 2^BLOCK_BITS pulses for each word of 347
    parameter ENDS = 120,         // 347: the trapezoid
    parameter MIDDLE = 20,
    parameter RAMP = 16,
    parameter BLOCKS = 82
) (
    input wire clk,
    input wire start,
    input wire signed [15:0] j,
    input wire signed [15:0] k,
    input wire signed [15:0] l,
    input wire signed [15:0] m,
    input wire signed [15:0] x0,
    input wire signed [15:0] y0,
    input wire [2:0] quarters,
    input wire [7:0] delay,            // modes 1 and 4: the interval in ticks
    input wire [15:0] reference_340,   // mode 2: acceleration in pulses per 2^n ticks, per 2^n ticks
    input wire preset_write,           // mode 3: writes a word of 347
    input wire [7:0] preset_address,
    input wire [7:0] preset_word,
    output wire signed [15:0] x,
    output wire signed [15:0] y,
    output wire up_304,
    output wire down_306,
    output wire up_314,
    output wire down_316,
    output wire hold_345,
    output wire started,               // 1 in the tick of a start that is accepted
    output wire busy,
    output wire done,
    output wire error
);
    wire inhibit_329;
    wire pulse_290, pulse_292;

    incremental_generator #(
        .WIDTH(WIDTH),
        .ENTRIES(ENTRIES),
        .ENTRY_WIDTH(ENTRY_WIDTH),
        .GUARD(GUARD),
        .HALF(HALF)
    ) generator_16 (
        .clk(clk),
        .start(start),
        .j(j),
        .k(k),
        .l(l),
        .m(m),
        .x0(x0),
        .y0(y0),
        .quarters(quarters),
        .hold(hold_345),
        .inhibit(inhibit_329),
        .fast(1'b0),
        .x(x),
        .y(y),
        .up_304(up_304),
        .down_306(down_306),
        .up_314(up_314),
        .down_316(down_316),
        .pulse_290(pulse_290),
        .pulse_292(pulse_292),
        .started(started),
        .busy(busy),
        .done(done),
        .error(error)
    );

    // 338, 339: acceleration, and its difference from reference 340.
    localparam BITS = $clog2(WINDOW);
    wire [BITS+1:0] acceleration_338;
    wire signed [17:0] difference_339;
    analyzer_338 #(.BITS(BITS)) analyzer_338 (
        .clk(clk),
        .clear(started),
        .up_304(up_304),
        .down_306(down_306),
        .up_314(up_314),
        .down_316(down_316),
        .velocity_x(),
        .velocity_y(),
        .acceleration_x(),
        .acceleration_y(),
        .acceleration(acceleration_338)
    );
    difference_circuit #(.WIDTH(17)) difference_circuit_339 (
        .measured({{(15 - BITS){1'b0}}, acceleration_338}),
        .reference({1'b0, reference_340}),
        .difference(difference_339)
    );
    wire [7:0] regulated;
    delay_regulator #(
        .WIDTH(8),
        .DIFFERENCE_WIDTH(18),
        .PERIOD(WINDOW),
        .MIN(MIN_DELAY),
        .MAX(MAX_DELAY),
        .STEP(STEP)
    ) regulator_341_342 (
        .clk(clk),
        .preset(started),
        .difference(difference_339),
        .interval(regulated)
    );

    // 346, 347: the way travelled, and the interval for each part of it.
    wire [BLOCK_BITS+7:0] travelled_346;
    wire [7:0] word_347;
    trajectory_counter #(.WIDTH(BLOCK_BITS + 8), .LINES(4)) counter_346 (
        .clk(clk),
        .clear(started),
        .lines({down_316, up_314, down_306, up_304}),
        .count(travelled_346)
    );
    presettable_memory #(
        .WIDTH(8),
        .ADDRESS_WIDTH(8),
        .ENDS(ENDS),
        .MIDDLE(MIDDLE),
        .RAMP(RAMP),
        .BLOCKS(BLOCKS)
    ) memory_347 (
        .clk(clk),
        .address(travelled_346[BLOCK_BITS+7:BLOCK_BITS]),
        .write(preset_write),
        .write_address(preset_address),
        .write_word(preset_word),
        .word(word_347)
    );

    // Where the interval comes from (chosen: the figure draws two alternatives).
    wire [7:0] interval_1_or_2, interval;
    multiplexer #(.WIDTH(8)) multiplexer_interval_1_or_2 (
        .a(MODE == 1 || MODE == 4),
        .b(MODE == 2),
        .x1(delay),
        .x2(regulated),
        .z(interval_1_or_2)
    );
    multiplexer #(.WIDTH(8)) multiplexer_interval (
        .a(MODE != 3),
        .b(MODE == 3),
        .x1(interval_1_or_2),
        .x2(word_347),
        .z(interval)
    );

    // 341, 342: the delays after each pulse. 343, 344, 345: hold the clock while a pulse is too early.
    wire x_pulse, y_pulse, x_trigger, y_trigger;
    wire busy_341, busy_342, hold_343, hold_344;
    or or_x_pulse (x_pulse, up_304, down_306);
    or or_y_pulse (y_pulse, up_314, down_316);
    programmable_delay #(.WIDTH(8)) delay_341 (
        .clk(clk),
        .pulse(x_trigger),
        .interval(interval),
        .busy(busy_341),
        .remaining()
    );
    programmable_delay #(.WIDTH(8)) delay_342 (
        .clk(clk),
        .pulse(y_trigger),
        .interval(interval),
        .busy(busy_342),
        .remaining()
    );
    and and_343 (hold_343, x_pulse, busy_341);
    and and_344 (hold_344, y_pulse, busy_342);
    or or_345 (hold_345, hold_343, hold_344);

    // Claim 17: the delays run after each element of 262 to 270, also those that guard stages keep back, and no clock
    // pulse begins meanwhile.
    wire claim_17, x_element, y_element, waiting;
    assign claim_17 = MODE == 4;
    and and_x_element (x_element, pulse_290, claim_17);
    and and_y_element (y_element, pulse_292, claim_17);
    or or_x_trigger (x_trigger, x_pulse, x_element);
    or or_y_trigger (y_trigger, y_pulse, y_element);
    or or_waiting (waiting, busy_341, busy_342);
    and and_inhibit_329 (inhibit_329, waiting, claim_17);
endmodule
