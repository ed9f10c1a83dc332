using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Metrics;

/// <summary>A creature's bones as masses in the middles of their capsules, in the world, and their energies from one frame to the next.</summary>
internal sealed class PointMasses
{
    private readonly int[] joints;
    private readonly Vector3[] middles;
    private readonly double[] masses;

    /// <summary>Of each bone, the number of its limb from 1, or 0 for what is of none.</summary>
    private readonly int[] groups;
    private readonly int groupCount;
    private Vector3[] before;
    private Vector3[] now;

    public PointMasses(MotionSubject subject)
    {
        int count = subject.Bones.Count;
        joints = new int[count];
        middles = new Vector3[count];
        masses = new double[count];
        groups = new int[count];
        before = new Vector3[count];
        now = new Vector3[count];
        groupCount = subject.Limbs.Count + 1;
        double sum = 0;
        for (int i = 0; i < count; i++)
        {
            CapsuleCollider capsule = subject.Bones[i];
            joints[i] = capsule.Joint;
            middles[i] = (capsule.Start + capsule.End) * 0.5f;
            masses[i] = capsule.Radius * capsule.Radius * (Vec.Length(capsule.End - capsule.Start) + (4.0 / 3 * capsule.Radius));
            groups[i] = GroupOf(subject, capsule.Joint);
            sum += masses[i];
        }

        for (int i = 0; i < count; i++)
        {
            masses[i] *= subject.Mass.Mass / sum;
        }
    }

    /// <summary>Takes the animator's pose; the one before is kept beside it.</summary>
    public void Move(CreatureAnimator animator)
    {
        (before, now) = (now, before);
        Pose pose = animator.ModelPose;
        for (int i = 0; i < joints.Length; i++)
        {
            now[i] = animator.Root.ToWorld(pose.Positions[joints[i]] + Rotation.Rotate(pose.Rotations[joints[i]], middles[i]));
        }
    }

    /// <summary>Energies in the middle between the last two poses, joules: first that of the centre of mass, kinetic and potential; then of each limb, the rest of the body first, the kinetic energy about the centre of mass.</summary>
    /// <param name="step">Seconds from the one to the other.</param>
    public double[] Energies(double step)
    {
        double mass = 0, x = 0, y = 0, z = 0, height = 0;
        for (int i = 0; i < masses.Length; i++)
        {
            mass += masses[i];
            x += masses[i] * (now[i].X - before[i].X) / step;
            y += masses[i] * (now[i].Y - before[i].Y) / step;
            z += masses[i] * (now[i].Z - before[i].Z) / step;
            height += masses[i] * 0.5 * ((double)now[i].Y + before[i].Y);
        }

        (x, y, z) = (x / mass, y / mass, z / mass);
        double[] energies = new double[groupCount + 1];
        energies[0] = (0.5 * mass * ((x * x) + (y * y) + (z * z))) + (StandardGravity.Acceleration * height);
        for (int i = 0; i < masses.Length; i++)
        {
            double u = ((now[i].X - before[i].X) / step) - x, v = ((now[i].Y - before[i].Y) / step) - y, w = ((now[i].Z - before[i].Z) / step) - z;
            energies[1 + groups[i]] += 0.5 * masses[i] * ((u * u) + (v * v) + (w * w));
        }

        return energies;
    }

    private static int GroupOf(MotionSubject subject, int joint)
    {
        for (int limb = 0; limb < subject.Limbs.Count; limb++)
        {
            foreach (int one in subject.Limbs[limb].Joints)
            {
                if (one == joint)
                {
                    return limb + 1;
                }
            }
        }

        return 0;
    }
}
