using CreatureGen.Anatomy;
using CreatureGen.Maths;

namespace CreatureGen.Blueprints;

/// <summary>Ranges that many fields share.</summary>
internal static class CommonRanges
{
    /// <summary>A place along the body, rings.</summary>
    public static readonly NumberRange Ring = new(0, BodyGrid.Rings - 1);

    /// <summary>A place around the left half of the body, segments from back to belly.</summary>
    public static readonly NumberRange Segment = new(0, BodyGrid.Segments / 2);

    /// <summary>A part of a whole.</summary>
    public static readonly NumberRange Fraction = new(0, 1);

    /// <summary>A factor on a size, 1 for as it is.</summary>
    public static readonly NumberRange Factor = new(0.2, 4);

    /// <summary>An angle, radians.</summary>
    public static readonly NumberRange Angle = new(-PortableMath.Pi, PortableMath.Pi);

    /// <summary>A component of a direction, whose length does not matter.</summary>
    public static readonly NumberRange Direction = new(-2, 2);
}
