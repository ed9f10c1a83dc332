using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Maths;

public sealed class RotationTests
{
    private const int Draws = 2000;

    private readonly RandomStream stream = new(77);

    [Fact]
    public void A_quarter_turn_about_each_axis_takes_the_next_axis_to_the_one_after()
    {
        Close(Vector3.UnitZ, Rotation.Rotate(Rotation.FromAxisAngle(Vector3.UnitX, Math.PI / 2), Vector3.UnitY));
        Close(Vector3.UnitX, Rotation.Rotate(Rotation.FromAxisAngle(Vector3.UnitY, Math.PI / 2), Vector3.UnitZ));
        Close(Vector3.UnitY, Rotation.Rotate(Rotation.FromAxisAngle(Vector3.UnitZ, Math.PI / 2), Vector3.UnitX));
    }

    [Fact]
    public void Turning_a_vector_is_the_formula_of_Rodrigues()
    {
        for (int i = 0; i < Draws; i++)
        {
            Vector3 axis = Direction();
            double angle = stream.Uniform(-10, 10);
            Vector3 v = Direction() * (float)stream.Uniform(0, 3);
            Vector3 expected = (v * (float)Math.Cos(angle)) + (Vec.Cross(axis, v) * (float)Math.Sin(angle)) + (axis * (Vec.Dot(axis, v) * (float)(1 - Math.Cos(angle))));
            Close(expected, Rotation.Rotate(Rotation.FromAxisAngle(axis, angle), v), 3e-6f);
            Close(Vec.Rotate(v, axis, angle), Rotation.Rotate(Rotation.FromAxisAngle(axis, angle), v), 3e-6f);
        }
    }

    [Fact]
    public void Turning_keeps_lengths_and_angles()
    {
        for (int i = 0; i < Draws; i++)
        {
            Quaternion q = Any();
            Vector3 a = Direction();
            Vector3 b = Direction();
            Assert.Equal(1, Vec.Length(Rotation.Rotate(q, a)), 1e-6f);
            Assert.Equal(Vec.Dot(a, b), Vec.Dot(Rotation.Rotate(q, a), Rotation.Rotate(q, b)), 1e-6f);
            Close(Rotation.Rotate(q, Vec.Cross(a, b)), Vec.Cross(Rotation.Rotate(q, a), Rotation.Rotate(q, b)), 2e-6f);
        }
    }

    [Fact]
    public void A_product_turns_by_its_second_factor_first()
    {
        for (int i = 0; i < Draws; i++)
        {
            Quaternion a = Any();
            Quaternion b = Any();
            Vector3 v = Direction();
            Close(Rotation.Rotate(a, Rotation.Rotate(b, v)), Rotation.Rotate(Rotation.Multiply(a, b), v), 2e-6f);
            Same(Quaternion.Multiply(a, b), Rotation.Multiply(a, b));
        }
    }

    [Fact]
    public void The_inverse_undoes()
    {
        for (int i = 0; i < Draws; i++)
        {
            Quaternion q = Any();
            Same(Quaternion.Identity, Rotation.Multiply(q, Rotation.Inverse(q)));
            Vector3 v = Direction();
            Close(v, Rotation.Rotate(Rotation.Inverse(q), Rotation.Rotate(q, v)), 2e-6f);
        }
    }

    [Fact]
    public void The_mirrored_rotation_turns_mirrored_vectors_to_mirrored_results()
    {
        for (int i = 0; i < Draws; i++)
        {
            Quaternion q = Any();
            Vector3 v = Direction();
            Assert.Equal(Vec.Mirror(Rotation.Rotate(q, v)), Rotation.Rotate(Rotation.Mirror(q), Vec.Mirror(v)));
            Vector3 w = Direction();
            Same(Rotation.Mirror(Rotation.FromTo(v, w)), Rotation.FromTo(Vec.Mirror(v), Vec.Mirror(w)));
        }
    }

    [Fact]
    public void The_arc_between_two_directions_is_the_shortest_one()
    {
        for (int i = 0; i < Draws; i++)
        {
            Vector3 a = Direction();
            Vector3 b = Direction();
            Quaternion q = Rotation.FromTo(a * 3f, b * 0.01f);
            Close(b, Rotation.Rotate(q, a));
            Assert.Equal(Math.Atan2(Vec.Length(Vec.Cross(a, b)), Vec.Dot(a, b)), Rotation.Angle(q), 1e-5);
            Assert.Equal(0, Vec.Dot(new Vector3(q.X, q.Y, q.Z), a), 1e-6f);
            Unit(q);
        }
    }

    [Fact]
    public void The_arc_to_the_opposite_direction_is_half_a_turn_about_a_perpendicular_axis()
    {
        for (int i = 0; i < Draws; i++)
        {
            Vector3 a = i switch { 0 => Vector3.UnitX, 1 => Vector3.UnitY, 2 => -Vector3.UnitZ, 3 => new Vector3(1, 1, 1), _ => Direction() };
            Quaternion q = Rotation.FromTo(a, -a);
            Unit(q);
            Close(-a, Rotation.Rotate(q, a));
            Assert.Equal(Math.PI, Rotation.Angle(q), 1e-6);
            q = Rotation.FromTo(a * 1e-20f, a * -1e15f);
            Close(-a, Rotation.Rotate(q, a));
        }
    }

    [Fact]
    public void The_arc_to_a_nearly_opposite_direction_still_arrives()
    {
        for (int i = 0; i < Draws; i++)
        {
            Vector3 a = Direction();
            Vector3 b = Vec.Normalize(-a + (Direction() * (float)PortableMath.Exp(stream.Uniform(-18, -4))));
            Quaternion q = Rotation.FromTo(a, b);
            Unit(q);
            Close(b, Rotation.Rotate(q, a), 2e-6f);
        }
    }

    [Fact]
    public void The_arc_of_a_small_angle_keeps_its_precision()
    {
        var b = new Vector3(1f, 1e-5f, 0f);
        Quaternion q = Rotation.FromTo(Vector3.UnitX, b);
        Assert.Equal(0.5e-5f, q.Z, 1e-11f);
        Assert.Equal(1e-5, Rotation.Angle(q), 1e-11);
        Assert.Equal(Quaternion.Identity, Rotation.FromTo(b, b));
    }

    [Fact]
    public void Without_a_direction_there_is_no_arc()
    {
        Assert.Equal(Quaternion.Identity, Rotation.FromTo(Vector3.Zero, Vector3.UnitX));
        Assert.Equal(Quaternion.Identity, Rotation.FromTo(Vector3.UnitX, Vector3.Zero));
        Assert.Equal(Quaternion.Identity, Rotation.Normalize(default));
    }

    [Fact]
    public void A_basis_and_its_rotation_are_each_others_inverse()
    {
        for (int i = 0; i < Draws; i++)
        {
            Quaternion q = Any();
            Rotation.ToBasis(q, out Vector3 x, out Vector3 y, out Vector3 z);
            Close(Rotation.Rotate(q, Vector3.UnitX), x);
            Close(Rotation.Rotate(q, Vector3.UnitY), y);
            Close(Rotation.Rotate(q, Vector3.UnitZ), z);
            SameTurn(q, Rotation.FromBasis(x, y, z));
        }
    }

    [Fact]
    public void A_basis_turned_by_half_or_nearly_half_a_turn_is_found()
    {
        for (int i = 0; i < Draws; i++)
        {
            Vector3 axis = i switch { 0 => Vector3.UnitX, 1 => Vector3.UnitY, 2 => Vector3.UnitZ, 3 => Vec.Normalize(new Vector3(1, 1, 0)), _ => Direction() };
            double angle = Math.PI + (i < 4 ? 0 : stream.Uniform(-1e-3, 1e-3));
            Quaternion q = Rotation.FromAxisAngle(axis, angle);
            Rotation.ToBasis(q, out Vector3 x, out Vector3 y, out Vector3 z);
            SameTurn(q, Rotation.FromBasis(x, y, z));
        }
    }

    [Fact]
    public void Slerp_goes_the_shorter_way_at_even_speed()
    {
        for (int i = 0; i < Draws; i++)
        {
            Quaternion a = Any();
            Quaternion b = Any();
            double whole = Rotation.Angle(Rotation.Multiply(Rotation.Inverse(a), b));
            SameTurn(a, Rotation.Slerp(a, b, 0));
            SameTurn(b, Rotation.Slerp(a, b, 1));
            double t = stream.Uniform();
            Quaternion q = Rotation.Slerp(a, b, t);
            Unit(q);
            Assert.Equal(t * whole, Rotation.Angle(Rotation.Multiply(Rotation.Inverse(a), q)), 2e-6);
            Assert.Equal((1 - t) * whole, Rotation.Angle(Rotation.Multiply(Rotation.Inverse(q), b)), 2e-6);
            SameTurn(q, Rotation.Slerp(a, Negated(b), t));
        }
    }

    [Fact]
    public void Slerp_between_nearly_the_same_rotations_is_even_too()
    {
        for (int i = 0; i < Draws; i++)
        {
            Vector3 axis = Direction();
            double angle = PortableMath.Exp(stream.Uniform(-14, -4));
            Quaternion q = Rotation.Slerp(Quaternion.Identity, Rotation.FromAxisAngle(axis, angle), 0.25);
            Quaternion expected = Rotation.FromAxisAngle(axis, 0.25 * angle);
            Assert.Equal(expected.X, q.X, 1e-4f * (float)angle);
            Assert.Equal(expected.Y, q.Y, 1e-4f * (float)angle);
            Assert.Equal(expected.Z, q.Z, 1e-4f * (float)angle);
        }

        Assert.Equal(Quaternion.Identity, Rotation.Slerp(Quaternion.Identity, Quaternion.Identity, 0.3));
    }

    [Fact]
    public void Slerp_and_nlerp_meet_in_the_middle_and_go_on_beyond_the_ends()
    {
        Quaternion a = Quaternion.Identity;
        Quaternion b = Rotation.FromAxisAngle(Vector3.UnitY, 1);
        SameTurn(Rotation.FromAxisAngle(Vector3.UnitY, 0.5), Rotation.Nlerp(a, b, 0.5));
        SameTurn(Rotation.FromAxisAngle(Vector3.UnitY, 0.5), Rotation.Slerp(a, b, 0.5));
        SameTurn(Rotation.FromAxisAngle(Vector3.UnitY, 1.5), Rotation.Slerp(a, b, 1.5));
        SameTurn(b, Rotation.Nlerp(a, Negated(b), 1));
        SameTurn(Rotation.FromAxisAngle(Vector3.UnitY, -0.5), Rotation.Slerp(a, b, -0.5));
        Unit(Rotation.Nlerp(a, Rotation.FromAxisAngle(Vector3.UnitY, Math.PI), 0.5));
    }

    [Fact]
    public void Swing_and_twist_multiply_to_the_rotation_and_keep_to_their_axes()
    {
        for (int i = 0; i < Draws; i++)
        {
            Quaternion q = Any();
            Vector3 axis = Direction();
            Rotation.SwingTwist(q, axis, out Quaternion swing, out Quaternion twist);
            Unit(swing);
            Unit(twist);
            SameTurn(q, Rotation.Multiply(swing, twist));
            Close(axis, Rotation.Rotate(twist, axis));
            Assert.Equal(0, Vec.Dot(axis, new Vector3(swing.X, swing.Y, swing.Z)), 1e-6f);
            Assert.True(swing.W >= 0 && twist.W >= 0);
            Close(Rotation.Rotate(q, axis), Rotation.Rotate(swing, axis));
        }
    }

    [Fact]
    public void A_pure_twist_has_no_swing_and_a_pure_swing_no_twist()
    {
        Quaternion q = Rotation.FromAxisAngle(Vector3.UnitY, 2.5);
        Rotation.SwingTwist(q, Vector3.UnitY, out Quaternion swing, out Quaternion twist);
        Same(Quaternion.Identity, swing);
        Same(q, twist);

        q = Rotation.FromAxisAngle(Vector3.UnitX, 2.5);
        Rotation.SwingTwist(q, Vector3.UnitY, out swing, out twist);
        Same(q, swing);
        Same(Quaternion.Identity, twist);
    }

    [Fact]
    public void Half_a_turn_across_the_axis_is_all_swing()
    {
        foreach (double angle in new[] { Math.PI, -Math.PI, Math.PI + 1e-9, 3 * Math.PI })
        {
            Quaternion q = Rotation.FromAxisAngle(Vector3.UnitX, angle);
            Rotation.SwingTwist(q, Vector3.UnitY, out Quaternion swing, out Quaternion twist);
            SameTurn(q, swing);
            Same(Quaternion.Identity, twist);
        }
    }

    [Fact]
    public void The_angle_of_a_rotation_is_between_nothing_and_half_a_turn()
    {
        Assert.Equal(0, Rotation.Angle(Quaternion.Identity));
        Assert.Equal(0, Rotation.Angle(Negated(Quaternion.Identity)));
        for (int i = 0; i < Draws; i++)
        {
            double angle = stream.Uniform(0, Math.PI);
            Quaternion q = Rotation.FromAxisAngle(Direction(), angle);
            Assert.Equal(angle, Rotation.Angle(q), 1e-6);
            Assert.Equal(angle, Rotation.Angle(Negated(q)), 1e-6);
        }
    }

    [Fact]
    public void Normalising_after_many_products_restores_the_length()
    {
        Quaternion step = Rotation.FromAxisAngle(Direction(), 0.1);
        Quaternion q = new(step.X * 1.01f, step.Y * 1.01f, step.Z * 1.01f, step.W * 1.01f);
        for (int i = 0; i < 100; i++)
        {
            q = Rotation.Multiply(q, step);
        }

        Unit(Rotation.Normalize(q));
    }

    [Fact]
    public void The_perpendicular_of_a_direction_is_a_unit_vector_across_it()
    {
        for (int i = 0; i < Draws; i++)
        {
            Vector3 a = i switch { 0 => Vector3.UnitX, 1 => Vector3.UnitY, 2 => Vector3.UnitZ, 3 => Vector3.One, _ => Direction() * (float)stream.Uniform(0.01, 100) };
            Vector3 p = Vec.Perpendicular(a);
            Assert.Equal(1, Vec.Length(p), 1e-6f);
            Assert.Equal(0, Vec.Dot(p, Vec.Normalize(a)), 1e-6f);
        }

        Assert.Equal(Vector3.UnitX, Vec.Perpendicular(Vector3.Zero));
    }

    private Vector3 Direction()
    {
        while (true)
        {
            var v = new Vector3((float)stream.Uniform(-1, 1), (float)stream.Uniform(-1, 1), (float)stream.Uniform(-1, 1));
            float length = Vec.Length(v);
            if (length is > 0.1f and < 1f)
            {
                return v / length;
            }
        }
    }

    private Quaternion Any() => Rotation.FromAxisAngle(Direction(), stream.Uniform(-2 * Math.PI, 2 * Math.PI));

    private static Quaternion Negated(Quaternion q) => new(-q.X, -q.Y, -q.Z, -q.W);

    private static void Unit(Quaternion q) =>
        Assert.Equal(1, (q.X * q.X) + (q.Y * q.Y) + (q.Z * q.Z) + (q.W * q.W), 5e-7f);

    private static void Close(Vector3 expected, Vector3 actual, float tolerance = 1e-6f) =>
        Assert.True(Vec.Distance(expected, actual) <= tolerance, $"{actual}; expected {expected}");

    private static void Same(Quaternion expected, Quaternion actual)
    {
        Assert.Equal(expected.X, actual.X, 1e-6f);
        Assert.Equal(expected.Y, actual.Y, 1e-6f);
        Assert.Equal(expected.Z, actual.Z, 1e-6f);
        Assert.Equal(expected.W, actual.W, 1e-6f);
    }

    private static void SameTurn(Quaternion expected, Quaternion actual)
    {
        double angle = Rotation.Angle(Rotation.Multiply(Rotation.Inverse(expected), actual));
        Assert.True(angle <= 2e-6, $"{actual} is {angle:G3} rad from {expected}");
    }
}
