module n022_computing (input wire [3:0] a, b, output wire [3:0] c, d, e, f, g, output wire h, i);
    assign c = a & b;
    assign d = a + 1;
    assign e = a[0] ? a : b;
    assign f = ~a;
    assign g = a << 1;
    assign h = a == b;
    and and_1 (i, !a[0], |b);
endmodule
