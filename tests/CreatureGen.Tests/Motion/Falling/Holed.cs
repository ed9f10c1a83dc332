using System;
using System.Numerics;
using CreatureGen.Motion;

namespace CreatureGen.Tests.Motion.Falling;

/// <summary>Level ground with holes that have no bottom.</summary>
internal sealed class Holed(float height, Func<Vector3, bool> isHole) : IGround
{
    public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
    {
        hit = default;
        float along = origin.Y <= height ? 0f : direction.Y < 0f ? (height - origin.Y) / direction.Y : -1f;
        if (!(along >= 0f && along <= distance))
        {
            return false;
        }

        Vector3 point = (origin + (along * direction)) with { Y = height };
        hit = new GroundHit(point, Vector3.UnitY);
        return !isHole(point);
    }
}
