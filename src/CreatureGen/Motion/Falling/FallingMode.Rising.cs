using System.Collections.Generic;
using CreatureGen.Motion.Events;
using CreatureGen.Motion.Modes;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <content>How it gets up.</content>
internal sealed partial class FallingMode
{
    /// <summary>Steps of the search for how it gets up in an update in which it lies: as it falls and comes to rest, which takes some sixty updates, most come to its end.</summary>
    private const int StepsInUpdate = 3;

    private IEnumerator<bool>? finding;

    /// <summary>Has it get up as soon as it lies still.</summary>
    /// <returns>Whether it lies, or will with the next update.</returns>
    public bool GetUp()
    {
        getsUp = State == BodyState.Limp || goesLimp;
        if (getsUp)
        {
            // Here and not in an update, for finding out how a creature lies takes a while.
            _ = Up;
        }

        return getsUp;
    }

    /// <summary>Goes on finding out how it gets up, a little in each update in which it lies: it takes tens of milliseconds.</summary>
    private void Prepare()
    {
        for (int step = 0; step < StepsInUpdate && up == null; step++)
        {
            finding ??= profile.Value.FindLying().GetEnumerator();
            if (!finding.MoveNext())
            {
                finding = null;
                _ = Up;
            }
        }
    }

    /// <summary>Begins to get up from where it lies.</summary>
    private RootPlace Rise(in RootPlace place, in MotionSettings settings, IGround ground, BodyLayer? layer)
    {
        while (up == null)
        {
            Prepare();
        }

        RootPlace stand = Lying.PlaceUnder(place, settings, ground);
        Up.Begin(Lying, stand, settings, ground, layer);
        Lying.Stop();
        getsUp = false;
        State = BodyState.Rising;
        Tell(MotionEventKind.Rises, stand, settings.Up, 0f, 0f);
        return stand;
    }
}
