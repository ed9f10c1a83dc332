using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Flying;

/// <summary>What a flier has travelled.</summary>
/// <param name="Root">How far its root went, metres of the model.</param>
/// <param name="Ahead">The way along its own nose, metres of the model; below 0 backwards.</param>
/// <param name="Seconds">In this time.</param>
internal readonly record struct FlightWay(RootDelta Root, double Ahead, float Seconds)
{
    /// <summary>The same with another piece behind it, along an arc.</summary>
    public FlightWay Then(double ahead, double up, double turned, float seconds)
    {
        // The chord of an arc is shorter than the arc: sin x / x of half of its angle, to the fourth power of that.
        double chord = 1 - (turned * turned / 24);
        Vector3 piece = new(0f, (float)up, (float)(ahead * chord));
        float heading = Root.Turn + (float)(0.5 * turned);
        Vector3 way = heading == 0f ? piece : Rotation.Rotate(AxisRotation.Yaw(heading), piece);
        return new FlightWay(new RootDelta(Root.Shift + way, Root.Turn + (float)turned), Ahead + ahead, Seconds + seconds);
    }
}
