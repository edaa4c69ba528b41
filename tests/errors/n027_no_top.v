module one (input wire a, output wire b);
    assign b = a;
endmodule

module two (input wire a, output wire b);
    assign b = a;
endmodule
