using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;

namespace CreatureGen.Rigging;

/// <summary>Gives the head its jaw, its eyes and their lids.</summary>
internal static class HeadRigger
{
    /// <summary>Segment of the mouth slit on the left flank.</summary>
    private const int SlitSegment = 10;

    /// <summary>How much wider than at rest lids open, radians.</summary>
    private const float Widening = 0.2f;

    /// <summary>Adds the jaw, which turns about the line through both flanks behind the lip corners, and gives its joint; −1 without a mouth.</summary>
    public static int AddJaw(SkeletonBuilder skeleton, RigInput input, int head)
    {
        MouthSeam mouth = input.Mouth;
        if (!mouth.Opens)
        {
            return -1;
        }

        BodyShape shape = input.Skin.Shape;
        Vector3 hinge = input.Skin[mouth.HingeRing, SlitSegment];
        hinge.X = 0f;

        // The chin: under the middle of the lower lip.
        Vector3 chin = input.Surface.Positions[mouth.LowerLip[mouth.LowerLip.Length / 2]] - (shape.Up(StationRing.Nose) * (float)(shape.Bottom[StationRing.Nose] / 2));
        chin.X = 0f;
        if (input.Blueprint.Head.Beak is BeakBlueprint beak)
        {
            // The lip is as far ahead of the first ring as the nose bulges.
            chin += shape.Forward(StationRing.Nose) * (BillReach.Of(beak, shape).Lower - MouthSlit.NoseBulge(shape));
        }

        Vector3 direction = chin - hinge;
        int jaw = skeleton.Add(head, Side.Median, new JointDefinition("Jaw", JointRole.Jaw, hinge, JointFrame.Median(direction), Vec.Length(direction), JointLimits.Body(JointRole.Jaw)));
        skeleton.AddEnd(jaw, Side.Median, "JawEnd", chin);
        return jaw;
    }

    /// <summary>Adds both eyes; +Y of their joints is the gaze.</summary>
    public static void AddEyes(SkeletonBuilder skeleton, EyeSocket eye, int head)
    {
        Quaternion frame = JointFrame.Raised(eye.Gaze, -Vector3.UnitY);
        JointDefinition[] left =
        {
            new("Eye_L", JointRole.Eye, eye.Centre, frame, eye.Radius, JointLimits.Body(JointRole.Eye)),
            new("Eye_L_End", JointRole.End, eye.Centre + (eye.Gaze * eye.Radius), frame, 0f, JointLimit.Fixed),
        };
        skeleton.AddPair(head, left, new[] { "Eye_R", "Eye_R_End" });
        if (eye.Lids is LidHinge lids)
        {
            AddLids(skeleton, head, "UpperLid", eye, lids.Axis, lids.UpperRim, new AngleRange(-Widening, lids.UpperClosing));
            AddLids(skeleton, head, "LowerLid", eye, lids.Axis, lids.LowerRim, new AngleRange(-lids.LowerClosing, Widening));
        }
    }

    /// <summary>Adds a lid of both eyes; +X of its joint is the hinge, +Y points at its rim.</summary>
    private static void AddLids(SkeletonBuilder skeleton, int head, string name, EyeSocket eye, Vector3 axis, Vector3 rim, AngleRange turns)
    {
        Quaternion frame = Rotation.FromBasis(axis, rim, Vec.Cross(axis, rim));
        var limit = new JointLimit(turns, AngleRange.Both(0f), AngleRange.Both(0f));
        JointDefinition[] left =
        {
            new(name + "_L", JointRole.Lid, eye.Centre, frame, eye.Radius, limit),
            new(name + "_L_End", JointRole.End, eye.Centre + (rim * eye.Radius), frame, 0f, JointLimit.Fixed),
        };
        skeleton.AddPair(head, left, new[] { name + "_R", name + "_R_End" });
    }
}
