using System.Numerics;
using CreatureGen.Maths;

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

        return new RootPlace(goal.ToWorld(from.Position * Left), Rotation.Normalize(Rotation.Multiply(goal.Rotation, Turn)), goal.Scale);
    }

    /// <summary>Where it is to be, of where it is shown.</summary>
    public readonly RootPlace Goal(in RootPlace shown)
    {
        if (IsOver)
        {
            return shown;
        }

        Quaternion rotation = Rotation.Normalize(Rotation.Multiply(shown.Rotation, Rotation.Inverse(Turn)));
        return new RootPlace(shown.Position - (Rotation.Rotate(rotation, from.Position * Left) * shown.Scale), rotation, shown.Scale);
    }

    /// <summary>What is left of the way, 1 to 0.</summary>
    private readonly float Left => 1f - Scalar.Smooth(elapsed / seconds);

    /// <summary>Turn from where it is to be to where it is shown.</summary>
    private readonly Quaternion Turn => Rotation.Slerp(Quaternion.Identity, from.Rotation, Left);
}
