using System.Numerics;

namespace CreatureGen.Motion.Floating;

/// <summary>What the ground says of water where a body is: asked once in an update, and handed on.</summary>
internal readonly struct WaterReading
{
    private WaterReading(IWaterGround ground, float depth)
    {
        Ground = ground;
        Depth = depth;
    }

    /// <summary>The ground and its water; null where there is none.</summary>
    public IWaterGround? Ground { get; }

    /// <summary>How far the root is below the surface, metres; negative above it.</summary>
    public float Depth { get; }

    /// <summary>Asks the ground.</summary>
    /// <param name="ground">What the body goes on.</param>
    /// <param name="root">Where its root is, world space.</param>
    public static WaterReading At(IGround ground, Vector3 root)
    {
        if (!(ground is IWaterGround water))
        {
            return default;
        }

        float depth = water.DepthAt(root);
        return depth > float.MinValue ? new WaterReading(water, depth) : default;
    }
}
