using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>A root that is to be elsewhere at once, under a body that lies or the other way round, goes there in a while: what follows it, a camera or a name above its head, does not jump. The body stays where it is.</summary>
internal struct RootGlide
{
    private RootPlace from;
    private float seconds;
    private float elapsed;

    /// <summary>Whether the root is where it is to be.</summary>
    public readonly bool IsOver => !(elapsed < seconds);

    /// <summary>Begins.</summary>
    /// <param name="shown">Where the root is.</param>
    /// <param name="goal">Where it is to be.</param>
    /// <param name="seconds">In what time.</param>
    public void Begin(in RootPlace shown, in RootPlace goal, float seconds)
    {
        from = new RootPlace(goal.ToModel(shown.Position), Rotation.Normalize(Rotation.Multiply(Rotation.Inverse(goal.Rotation), shown.Rotation)));
        this.seconds = seconds;
        elapsed = 0f;
    }

    /// <summary>Goes on.</summary>
    /// <param name="dt">Seconds.</param>
    public void Advance(float dt) => elapsed += dt;

    /// <summary>Where it is shown, of where it is to be.</summary>
    public readonly RootPlace Shown(in RootPlace goal)
    {
        if (IsOver)
        {
            return goal;
        }

        float left = 1f - Scalar.Smooth(elapsed / seconds);
        return new RootPlace(goal.ToWorld(from.Position * left), Rotation.Normalize(Rotation.Multiply(goal.Rotation, TurnOf(left))), goal.Scale);
    }

    /// <summary>Where it is to be, of where it is shown.</summary>
    public readonly RootPlace Goal(in RootPlace shown)
    {
        if (IsOver)
        {
            return shown;
        }

        float left = 1f - Scalar.Smooth(elapsed / seconds);
        Quaternion rotation = Rotation.Normalize(Rotation.Multiply(shown.Rotation, Rotation.Inverse(TurnOf(left))));
        return new RootPlace(shown.Position - (Rotation.Rotate(rotation, from.Position * left) * shown.Scale), rotation, shown.Scale);
    }

    /// <summary>Writes a pose as seen from another root: the body stays where it is in the world.</summary>
    /// <param name="skeleton">Of the pose.</param>
    /// <param name="body">The joint that carries the body.</param>
    /// <param name="before">From where the pose is seen.</param>
    /// <param name="after">From where it is to be seen.</param>
    /// <param name="local">The pose, in the parents' space.</param>
    public static void Reframe(Skeleton skeleton, int body, in RootPlace before, in RootPlace after, in Pose local)
    {
        int parent = skeleton.Parents[body];
        Quaternion frame = parent < 0 ? Quaternion.Identity : skeleton.ModelRotations[parent];
        Vector3 origin = parent < 0 ? Vector3.Zero : skeleton.ModelPositions[parent];
        Quaternion back = Rotation.Inverse(frame);
        Quaternion turn = Rotation.Multiply(Rotation.Inverse(after.Rotation), before.Rotation);
        Vector3 place = after.ToModel(before.ToWorld(origin + Rotation.Rotate(frame, local.Positions[body])));
        local.Positions[body] = Rotation.Rotate(back, place - origin);
        local.Rotations[body] = Rotation.Normalize(Rotation.Multiply(back, Rotation.Multiply(turn, Rotation.Multiply(frame, local.Rotations[body]))));
    }

    private readonly Quaternion TurnOf(float part) => Rotation.Slerp(Quaternion.Identity, from.Rotation, part);
}
