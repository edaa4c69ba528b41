`default_nettype none

// Clipping circuit 384 of US 3,809,868, FIG. 16: draws only what is inside a window.
//
// Comparators 492 and 494 hold X(t) against X minimum 390 and X maximum 392, 496 and 498 hold Y(t) against Y maximum 396
// and Y minimum 394. Their outputs are combined: mark inhibit 100 blanks the display, and switch 109 gives the sine and
// cosine generators their full velocity, until X and Y are inside again. A point on a limit is inside (chosen).
//
// Everything is combinational: the mark goes off in the very tick in which X or Y leaves the window.
//
// With a minimum above its maximum nothing is inside, so that nothing is drawn wrongly, and `error` is high as long as
// it is so (chosen; the comparators for that have no numeral).
(* WIDTH_min = 1, WIDTH_max = 64 *)
module fig16_clipping #(
    parameter WIDTH = 16        // bits of all words
) (
    input wire signed [WIDTH-1:0] x,            // X(t)
    input wire signed [WIDTH-1:0] y,            // Y(t)
    input wire signed [WIDTH-1:0] x_min_390,
    input wire signed [WIDTH-1:0] x_max_392,
    input wire signed [WIDTH-1:0] y_min_394,
    input wire signed [WIDTH-1:0] y_max_396,
    output wire inside,
    output wire mark_inhibit_100,
    output wire full_speed_109,
    output wire error
);
    wire beyond_492, beyond_494, beyond_496, beyond_498;
    limit_comparator #(.WIDTH(WIDTH), .MAXIMUM(0)) comparator_492 (
        .reference(x_min_390), .comparison(x), .beyond(beyond_492)
    );
    limit_comparator #(.WIDTH(WIDTH), .MAXIMUM(1)) comparator_494 (
        .reference(x_max_392), .comparison(x), .beyond(beyond_494)
    );
    limit_comparator #(.WIDTH(WIDTH), .MAXIMUM(1)) comparator_496 (
        .reference(y_max_396), .comparison(y), .beyond(beyond_496)
    );
    limit_comparator #(.WIDTH(WIDTH), .MAXIMUM(0)) comparator_498 (
        .reference(y_min_394), .comparison(y), .beyond(beyond_498)
    );

    wire outside;
    or or_outside (outside, beyond_492, beyond_494, beyond_496, beyond_498);
    not not_outside (inside, outside);
    assign mark_inhibit_100 = outside;
    assign full_speed_109 = outside;

    wire no_width, no_height;
    limit_comparator #(.WIDTH(WIDTH), .MAXIMUM(1)) comparator_window_x (
        .reference(x_max_392), .comparison(x_min_390), .beyond(no_width)
    );
    limit_comparator #(.WIDTH(WIDTH), .MAXIMUM(1)) comparator_window_y (
        .reference(y_max_396), .comparison(y_min_394), .beyond(no_height)
    );
    or or_error (error, no_width, no_height);
endmodule
