using System.Numerics;

namespace CreatureGen.Animation.Strokes.Slithering;

/// <summary>The ground under a crawler.</summary>
public interface ISlitherGround
{
    /// <summary>Height and upward unit normal of the ground at a place, world space, metres.</summary>
    float Sample(float x, float z, out Vector3 normal);
}

/// <summary>A level floor.</summary>
public sealed class LevelGround : ISlitherGround
{
    private readonly float height;

    /// <summary>A floor at a height, metres.</summary>
    public LevelGround(float height = 0f) => this.height = height;

    /// <inheritdoc/>
    public float Sample(float x, float z, out Vector3 normal)
    {
        normal = Vector3.UnitY;
        return height;
    }
}
