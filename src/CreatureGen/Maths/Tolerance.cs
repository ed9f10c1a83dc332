namespace CreatureGen.Maths;

/// <summary>Every tolerance of the library, with its unit and its reason.</summary>
internal static class Tolerance
{
    /// <summary>Metres. A vector shorter than this has no direction worth normalising.</summary>
    public const float DirectionLength = 1e-9f;

    /// <summary>Of unit length. Two unit vectors whose sum is shorter are opposite: single-precision directions are exact to no more.</summary>
    public const double OppositeDirections = 1e-7;

    /// <summary>Metres. Soles may miss the ground by no more.</summary>
    public const float GroundMetres = 1e-4f;

    /// <summary>Part of the squared diagonal of the bounding box. A triangle with less area is degenerate for importers.</summary>
    public const double DegenerateAreaPerDiagonalSquared = 1e-12;

    /// <summary>Part of one. A unit vector or unit quaternion computed in floats misses unit length by a few roundings (about 2e-7 each); more means that it was never normalised.</summary>
    public const float UnitLength = 1e-4f;

    /// <summary>Part of one. Four weights rounded to floats miss a sum of one by a few roundings; more means that they were never normalised.</summary>
    public const float WeightSum = 1e-5f;

    /// <summary>Part of 1 m plus the distance from the origin, and of one for entries of rotation matrices. A joint's rest pose in its parent's space and in model space may differ by no more, which floats keep with two decimal places to spare.</summary>
    public const double RestPose = 1e-5;

    /// <summary>Part of the diagonal of the bounding box. Triangles that have a shorter segment in common touch, and do not cross.</summary>
    public const double CrossingLengthPerDiagonal = 1e-9;

    /// <summary>Part of the product of area and the bounding box's diagonal. A smaller volume is the rounding of single-precision positions.</summary>
    public const double VolumePerAreaAndDiagonal = 1e-12;
}
