using System;

namespace CreatureGen.Preview.Pictures;

/// <summary>Thin lines on diagrams.</summary>
internal static class Strokes
{
    /// <summary>Draws a straight line two pixels wide, both ends included.</summary>
    public static void Line(Picture picture, int fromX, int fromY, int toX, int toY, Pixel colour)
    {
        int steps = Math.Max(Math.Max(Math.Abs(toX - fromX), Math.Abs(toY - fromY)), 1);
        for (int i = 0; i <= steps; i++)
        {
            picture.Fill(colour, fromX + ((toX - fromX) * i / steps), fromY + ((toY - fromY) * i / steps), 2, 2);
        }
    }
}
