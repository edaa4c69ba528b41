module n025_alias_loop (input wire a, output wire b, c, output wire [3:0] d);
    assign b = c;
    assign c = b;
    assign d = {d[2:1], d[3], a};
endmodule
