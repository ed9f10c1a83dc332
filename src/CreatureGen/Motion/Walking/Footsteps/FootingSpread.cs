using System;
using System.Numerics;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>How far places with ground spread around the middle of a body: between them it is carried.</summary>
internal struct FootingSpread
{
    /// <summary>How far the body may be beyond them, leg lengths.</summary>
    private const float Overhang = 0.1f;

    private float front;
    private float rear;
    private float left;
    private float right;

    /// <summary>No place yet.</summary>
    public static FootingSpread None => new() { front = float.MinValue, rear = float.MaxValue, left = float.MinValue, right = float.MaxValue };

    /// <summary>Adds a place, model space.</summary>
    public void Add(Vector3 place)
    {
        front = Math.Max(front, place.Z);
        rear = Math.Min(rear, place.Z);
        left = Math.Max(left, place.X);
        right = Math.Min(right, place.X);
    }

    /// <summary>Adds a foot from its heel to its toes.</summary>
    /// <param name="leg">Its leg.</param>
    /// <param name="ball">The place of its ball, model space.</param>
    public void AddSole(LegRig leg, Vector3 ball)
    {
        Add(ball + (leg.ToeDirection * leg.Toe));
        Add(ball - (leg.ToeDirection * leg.Heel));
    }

    /// <summary>Whether the middle of a body is among them.</summary>
    public readonly bool Carries(LeggedBody body)
    {
        Vector3 middle = body.Middle;
        float over = Overhang * body.LegLength;
        return front >= middle.Z - over && rear <= middle.Z + over && left >= middle.X - over && right <= middle.X + over;
    }
}
