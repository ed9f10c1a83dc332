using System;
using CreatureGen.Maths;

namespace CreatureGen.Anatomy.Tails;

/// <summary>The rays that a fin at the end of a tail is spread by: without them an upright one is a shield from behind, and a fluke a slab.</summary>
internal static class TailRays
{
    /// <summary>Rays of each side, one on every second segment of the body, so that vertices and texels show the same.</summary>
    private const int OnSide = 8;

    // By how much a ray is thicker and the skin beside it thinner than a fin without rays, and how far the edge between two rays lies ahead of their tips, in rings of the tail, and at most in sizes of the fin.
    private const double Relief = 0.4;
    private const double Scallop = 0.6;
    private const double DeepestScallop = 0.12;

    /// <summary>What is left of that on tails of sharks and tunas, which are stiff to their edge: scalloped deeper they are torn.</summary>
    private const double StiffScallop = 0.5;

    /// <summary>How often as broad as thick a fin is whose rays stand out fully.</summary>
    private const double Slim = 20;

    // From where on and over how many rings rays stand out of the stalk, and the last rings, over which the edge is drawn in.
    private const double First = 48;
    private const double Emerging = 4;
    private const double EdgeFirst = 51;
    private const double EdgeRings = 3;

    /// <summary>Whether a tail ends in a fin, which has rays.</summary>
    public static bool Has(TailStyle style) => style == TailStyle.Fluke || AreSplit(style);

    /// <summary>Whether the edge is drawn in between them: upright fins are skin between rays, flukes all flesh.</summary>
    public static bool AreSplit(TailStyle style) => style is TailStyle.Fork or TailStyle.Fan or TailStyle.Lance || TailFin.Of(style) != null;

    /// <summary>How far a place is off the nearest ray and how far rays stand out there, 0 on a ray and before the fin to 1 between two.</summary>
    /// <param name="ring">Ring of the body.</param>
    /// <param name="around">Radians around the body from the back.</param>
    public static double Between(double ring, double around) =>
        0.5 * (1 - PortableMath.Cos(2 * OnSide * around)) * Scalar.Smooth((ring - First) / Emerging);

    /// <summary>Factor on the half thickness of the fin.</summary>
    /// <param name="ring">Ring of the body.</param>
    /// <param name="around">Radians around the body from the back.</param>
    /// <param name="slimness">How often as broad as thick it is there: on a stalk rays are folds that cut through one another.</param>
    public static double ThicknessAt(double ring, double around, double slimness) =>
        1 + (Relief * Scalar.Smooth((slimness - 1) / (Slim - 1)) * (Scalar.Smooth((ring - First) / Emerging) - (2 * Between(ring, around))));

    /// <summary>How far the skin is drawn in towards the stalk, metres.</summary>
    /// <param name="style">Outline of the fin, whose edge is drawn in.</param>
    /// <param name="ring">Ring of the body.</param>
    /// <param name="around">Radians around the body from the back.</param>
    /// <param name="size">Size of the fin.</param>
    /// <param name="step">Metres between two rings.</param>
    public static double DrawnInAt(TailStyle style, double ring, double around, double size, double step) =>
        (style is TailStyle.Heterocercal or TailStyle.Lunate ? StiffScallop : 1) * Math.Min(Scallop * step, DeepestScallop * size) * Scalar.Smooth((ring - EdgeFirst) / EdgeRings) * Between(ring, around);
}
