// The display of FIG. 20 of US 3,809,868: a stroke turned in space, then drawn in X, Y and Z.
//
// Rotation as in fig20_rotation3d; its J', K', L', M' go to generator 640 (X, Y), N' and P' to 642 (Z), which together
// draw
//
//   X(t) = J' (cos t - 1) + K' sin t + X0
//   Y(t) = L' (cos t - 1) + M' sin t + Y0
//   Z(t) = N' (cos t - 1) + P' sin t + Z0
//
// The function of Z is lost in print; it is that of X and Y, and with it comes Z0, which the text omits.
//
// Chosen, where the patent is silent:
//  - 640 and 642 are generators of FIG. 9; of 642 only the channel of X is used ("essentially a single channel"), L and
//    M are 0. Both start in the same tick and keep step, so X, Y and Z are those of the same t;
//  - `linked` = 1: the stroke begins where the pen is, X0, Y0, Z0 are ignored. A turned stroke need not end on a whole
//    count, so who gives the coefficients of a linked figure does not know the initial points;
//  - `start` (one tick, with all inputs valid in that tick) begins the rotation, and its end starts both generators.
//    `busy` is high from the tick after the start to the end; a start meanwhile is ignored. `done` is high for one tick
//    after that. `error` goes with it and stays until the next start: a word beyond 16 bits on the way, or a turned
//    coefficient that 640 or 642 would refuse, or `quarters` not 1 to 4: then nothing is drawn. X, Y or Z carried
//    beyond 16 bits is told in the same way, at the end.
`default_nettype none

(* WIDTH_min = 1, WIDTH_max = 16, ENTRIES_min = 2, ENTRIES_max = 4096, ENTRY_WIDTH_min = 1, ENTRY_WIDTH_max = 16 *)
module fig20_display #(
    parameter WIDTH = 12,       // of the generators, see fig09_function_generator
    parameter ENTRIES = 128,
    parameter ENTRY_WIDTH = 6
) (
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
    input wire signed [15:0] x0,
    input wire signed [15:0] y0,
    input wire signed [15:0] z0,
    input wire linked,
    input wire [2:0] quarters,
    output wire signed [15:0] x,
    output wire signed [15:0] y,
    output wire signed [15:0] z,
    output wire up_304,
    output wire down_306,
    output wire up_314,
    output wire down_316,
    output wire up_z,
    output wire down_z,
    output wire busy,
    output wire done,
    output wire error
);
    // What the generators need after the rotation is kept until then.
    wire idle;
    wire begun;
    and and_begun (begun, start, idle);
    wire free;
    not not_linked (free, linked);
    wire signed [15:0] first_x;
    wire signed [15:0] first_y;
    wire signed [15:0] first_z;
    multiplexer #(.WIDTH(16)) multiplexer_x0 (.a(free), .b(linked), .x1(x0), .x2(x), .z(first_x));
    multiplexer #(.WIDTH(16)) multiplexer_y0 (.a(free), .b(linked), .x1(y0), .x2(y), .z(first_y));
    multiplexer #(.WIDTH(16)) multiplexer_z0 (.a(free), .b(linked), .x1(z0), .x2(z), .z(first_z));
    wire signed [15:0] held_x0;
    wire signed [15:0] held_y0;
    wire signed [15:0] held_z0;
    wire [2:0] held_quarters;
    register #(.WIDTH(16)) register_x0 (.clk(clk), .word(first_x), .enable(begun), .clear(1'b0), .q(held_x0));
    register #(.WIDTH(16)) register_y0 (.clk(clk), .word(first_y), .enable(begun), .clear(1'b0), .q(held_y0));
    register #(.WIDTH(16)) register_z0 (.clk(clk), .word(first_z), .enable(begun), .clear(1'b0), .q(held_z0));
    register #(.WIDTH(3)) register_quarters (
        .clk(clk), .word(quarters), .enable(begun), .clear(1'b0), .q(held_quarters)
    );

    // Rotation.
    wire signed [15:0] j_turned;
    wire signed [15:0] k_turned;
    wire signed [15:0] l_turned;
    wire signed [15:0] m_turned;
    wire signed [15:0] n_turned;
    wire signed [15:0] p_turned;
    wire done_rotation;
    wire error_rotation;
    fig20_rotation3d rotation (
        .clk(clk), .start(begun), .order_616(order_616),
        .angle_628(angle_628), .angle_632(angle_632), .angle_636(angle_636),
        .j(j), .k(k), .l(l), .m(m), .n(n), .p(p),
        .j_out(j_turned), .k_out(k_turned), .l_out(l_turned),
        .m_out(m_turned), .n_out(n_turned), .p_out(p_turned),
        .done(done_rotation), .error(error_rotation)
    );

    // A coefficient that either generator would refuse keeps both from drawing.
    wire beyond_j;
    polarity_detector #(.WIDTH(16), .MAGNITUDE_WIDTH(WIDTH)) detector_j (
        .clk(clk), .load(1'b0), .word(j_turned), .out_of_range(beyond_j)
    );
    wire beyond_k;
    polarity_detector #(.WIDTH(16), .MAGNITUDE_WIDTH(WIDTH)) detector_k (
        .clk(clk), .load(1'b0), .word(k_turned), .out_of_range(beyond_k)
    );
    wire beyond_l;
    polarity_detector #(.WIDTH(16), .MAGNITUDE_WIDTH(WIDTH)) detector_l (
        .clk(clk), .load(1'b0), .word(l_turned), .out_of_range(beyond_l)
    );
    wire beyond_m;
    polarity_detector #(.WIDTH(16), .MAGNITUDE_WIDTH(WIDTH)) detector_m (
        .clk(clk), .load(1'b0), .word(m_turned), .out_of_range(beyond_m)
    );
    wire beyond_n;
    polarity_detector #(.WIDTH(16), .MAGNITUDE_WIDTH(WIDTH)) detector_n (
        .clk(clk), .load(1'b0), .word(n_turned), .out_of_range(beyond_n)
    );
    wire beyond_p;
    polarity_detector #(.WIDTH(16), .MAGNITUDE_WIDTH(WIDTH)) detector_p (
        .clk(clk), .load(1'b0), .word(p_turned), .out_of_range(beyond_p)
    );
    wire bad;
    wire good;
    or or_bad (bad, error_rotation, beyond_j, beyond_k, beyond_l, beyond_m, beyond_n, beyond_p);
    not not_bad (good, bad);

    // The end of the rotation: start the generators, or give up.
    wire done_before;
    wire was_not_done;
    wire rotated;
    wire launch;
    wire failed;
    delay_element #(.DELAY(1)) delay_rotated (.clk(clk), .pulse_in(done_rotation), .pulse_out(done_before));
    not not_done (was_not_done, done_before);
    and and_rotated (rotated, done_rotation, was_not_done, busy);
    and and_launch (launch, rotated, good);
    and and_failed (failed, rotated, bad);

    wire done_640;
    wire error_640;
    fig09_function_generator #(.WIDTH(WIDTH), .ENTRIES(ENTRIES), .ENTRY_WIDTH(ENTRY_WIDTH)) generator_640 (
        .clk(clk), .start(launch), .j(j_turned), .k(k_turned), .l(l_turned), .m(m_turned),
        .x0(held_x0), .y0(held_y0), .quarters(held_quarters), .x(x), .y(y),
        .up_304(up_304), .down_306(down_306), .up_314(up_314), .down_316(down_316),
        .done(done_640), .error(error_640)
    );
    wire done_642;
    wire error_642;
    fig09_function_generator #(.WIDTH(WIDTH), .ENTRIES(ENTRIES), .ENTRY_WIDTH(ENTRY_WIDTH)) generator_642 (
        .clk(clk), .start(launch), .j(n_turned), .k(p_turned), .l(16'd0), .m(16'd0),
        .x0(held_z0), .y0(16'd0), .quarters(held_quarters), .x(z),
        .up_304(up_z), .down_306(down_z),
        .done(done_642), .error(error_642)
    );

    // The end.
    wire drawn;
    wire bad_end;
    wire wrong;
    wire finished;
    wire carried;
    and and_drawn (drawn, done_640, done_642);
    or or_carried (carried, error_640, error_642);
    and and_bad_end (bad_end, drawn, carried);
    or or_wrong (wrong, failed, bad_end);
    or or_finished (finished, failed, drawn);
    trigger trigger_busy (.clk(clk), .set(begun), .reset(finished), .q(busy), .q_inverse(idle));
    trigger trigger_error (.clk(clk), .set(wrong), .reset(begun), .q(error));
    delay_element #(.DELAY(1)) delay_done (.clk(clk), .pulse_in(finished), .pulse_out(done));
endmodule
