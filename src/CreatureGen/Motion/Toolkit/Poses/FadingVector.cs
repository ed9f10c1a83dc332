using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit.Poses;

/// <summary>
/// A vector that goes from a value and a velocity to zero in a given time. Along its first direction it follows a <see cref="DecayCurve"/>; what velocity it has across
/// fades by u − 6u³ + 8u⁴ − 3u⁵ of the time, so that it moves aside and comes back.
/// </summary>
internal readonly struct FadingVector
{
    private readonly Vector3 direction;
    private readonly Vector3 across;
    private readonly DecayCurve along;
    private readonly float duration;

    /// <summary>Lays the curves.</summary>
    /// <param name="value">At time 0.</param>
    /// <param name="velocity">At time 0, per second.</param>
    /// <param name="duration">Seconds.</param>
    /// <param name="min">A value or a velocity per second that is shorter has no direction.</param>
    public FadingVector(Vector3 value, Vector3 velocity, float duration, float min)
    {
        float length = Vec.Length(value);
        float speed = Vec.Length(velocity);
        if ((length <= min && speed <= min) || duration <= 0f)
        {
            this = default;
            return;
        }

        direction = length > min ? value / length : velocity / speed;
        float outward = Vec.Dot(velocity, direction);
        along = new DecayCurve(length > min ? length : 0f, outward, duration);
        across = (velocity - (direction * outward)) * duration;
        this.duration = duration;
    }

    /// <summary>The vector at a time, seconds.</summary>
    public Vector3 At(float time)
    {
        if (time >= duration)
        {
            return Vector3.Zero;
        }

        float u = time / duration;
        float aside = u * (1f - (u * u * (6f - (u * (8f - (3f * u))))));
        return (direction * along.At(time)) + (across * aside);
    }
}
