namespace CreatureGen.Maths;

/// <summary>Every tolerance of the library, with its unit and its reason.</summary>
public static class Tolerance
{
    /// <summary>Metres. A vector shorter than this has no direction worth normalising.</summary>
    public const float DirectionLength = 1e-9f;

    /// <summary>Of unit length. Two unit vectors whose sum is shorter are opposite: single-precision directions are exact to no more.</summary>
    public const double OppositeDirections = 1e-7;

    /// <summary>Metres. Soles may miss the ground by no more.</summary>
    public const float GroundMetres = 1e-4f;

    /// <summary>Part of the squared diagonal of the bounding box. A triangle with less area is degenerate for importers.</summary>
    public const double DegenerateAreaPerDiagonalSquared = 1e-12;

    /// <summary>Part of the diagonal of the bounding box. Triangles that have a shorter segment in common touch, and do not cross.</summary>
    public const double CrossingLengthPerDiagonal = 1e-9;

    /// <summary>Part of the product of area and the bounding box's diagonal. A smaller volume is the rounding of single-precision positions.</summary>
    public const double VolumePerAreaAndDiagonal = 1e-12;
}
