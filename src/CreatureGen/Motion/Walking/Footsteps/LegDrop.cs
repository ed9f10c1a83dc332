using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>How far hind and fore body have come down for the legs: no quicker than a knee near straight can follow, however suddenly one of them asks for it or gives it up.</summary>
internal struct LegDrop
{
    /// <summary>How quickly at most, leg lengths per second.</summary>
    private const float Rate = 3f;

    private float hind;
    private float fore;
    private Vector3 way;
    private bool known;

    /// <summary>Goes on to what the legs ask for.</summary>
    /// <param name="dt">Seconds; 0 for one that is posed anew, who takes all of it.</param>
    /// <param name="legLength">Metres.</param>
    /// <param name="trunkWay">How far an act takes the trunk, metres: as quickly as it is thrown over its feet it may come down for them, too.</param>
    /// <param name="hindDrop">Asked of the hind body, metres; receives what it comes down.</param>
    /// <param name="foreDrop">The same of the fore body.</param>
    public void Follow(float dt, float legLength, Vector3 trunkWay, ref float hindDrop, ref float foreDrop)
    {
        if (known && dt > 0f)
        {
            float most = (Rate * legLength * dt) + Vec.Distance(trunkWay, way);
            hindDrop = Scalar.Clamp(hindDrop, hind - most, hind + most);
            foreDrop = Scalar.Clamp(foreDrop, fore - most, fore + most);
        }

        (hind, fore, way, known) = (hindDrop, foreDrop, trunkWay, true);
    }
}
