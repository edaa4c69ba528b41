module n002_strange_character (input wire a, output wire b);
    assign b = a €;
    wire c = "open;
endmodule
