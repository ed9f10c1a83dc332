namespace CreatureGen.Motion.Flying;

/// <summary>One moment of a flier's motion, as its legs see it.</summary>
internal struct LegStroke
{
    /// <summary>0 tucked, 1 hanging.</summary>
    public double Hanging;

    /// <summary>0..1, stretched towards the ground.</summary>
    public double Reaching;

    /// <summary>0 in the air, 1 with the feet on the ground.</summary>
    public double Planted;

    /// <summary>Height of the root above the ground, metres.</summary>
    public double Height;

    /// <summary>−1..1, swinging with the body's heave.</summary>
    public double Swing;
}
