namespace CreatureGen.Motion.Toolkit;

/// <summary>How a track goes from key to key.</summary>
public enum KeyInterpolation
{
    /// <summary>It stays at a key until the next one.</summary>
    Step,

    /// <summary>In a straight line at even speed; rotations along the shorter arc.</summary>
    Linear,

    /// <summary>Along a cubic curve with a tangent at each end (Hermite); rotations component by component, then brought to unit length.</summary>
    Cubic,
}
