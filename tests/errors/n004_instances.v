module n004_instances (input wire [3:0] a, output wire [3:0] b);
    multiplexer #(4) by_position (.a(a), .z(b));
    multiplexer #(.WIDTH(4)) ports_by_position (a, b);
    multiplexer #(.WIDTH(4)) star (.*);
    multiplexer #(.WIDTH(4)) many [3:0] (.a(a), .z(b));
    and #2 delayed (b[0], a[0]);
    and (strong0, strong1) strong (b[0], a[0]);
    and named (.out(b[0]));
    genvar i;
    for (genvar j = 0; j < 2; j = j + 1) begin : lane
        wire x = a[j];
    end
    for (i = 0; i < 2; i++) begin : other
    end
endmodule

module old_style (a, b);
    input a;
    output b;
endmodule
