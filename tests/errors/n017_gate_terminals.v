module n017_gate_terminals (input wire a, output wire b, c, d);
    not not_1 (b, a, a);
    buf buf_1 (c);
    and and_1 (d);
endmodule
