// A trapezoidal wing, 30 mm long, two rod pieces and two spars.
h = 0.006;
Point(1) = {0, 0, 0, h}; Point(2) = {0.012, 0, 0, h}; Point(3) = {0.018, 0, 0, h}; Point(4) = {0.030, 0, 0, h};
Point(5) = {0.030, 0.008, 0, h}; Point(6) = {0.020, 0.012, 0, h}; Point(7) = {0, 0.015, 0, h};
Line(1) = {2, 1}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 5}; Line(5) = {5, 6}; Line(6) = {6, 7}; Line(7) = {7, 1};
Line(8) = {6, 3};
Curve Loop(1) = {-1, 2, -8, 6, 7}; Plane Surface(1) = {1};
Curve Loop(2) = {8, 3, 4, 5}; Plane Surface(2) = {-2};
Physical Curve("rod-0", 10) = {1}; Physical Curve("rod-1", 11) = {2, 3};
Physical Curve("leading-edge", 12) = {1, 2, 3}; Physical Curve("trailing-edge", 13) = {5, 6};
Physical Curve("root", 14) = {7}; Physical Curve("spar-0", 15) = {8}; Physical Curve("spar-1", 16) = {4};
Physical Surface("membrane", 20) = {1, 2};
