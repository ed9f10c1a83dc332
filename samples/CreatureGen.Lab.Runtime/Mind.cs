using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Seeding;

namespace CreatureGen.Lab.Runtime;

/// <summary>What a creature wants: to stay, to stroll about its home, or to come where it is called.</summary>
internal sealed class Mind
{
    private const float PushSeconds = 0.35f;

    private readonly RandomStream chance;
    private SeekState seek;
    private Habit habit = Habit.Stay;
    private Vector2 home;
    private Vector2 goal;
    private float radius = 6f;
    private float timer;
    private bool travels;
    private bool called;
    private bool airborne;
    private Vector2 push;
    private float pushed;

    public Mind(int slot) => chance = new Seed(0x6c6162).Child("mind").Child(slot).Stream();

    private enum Habit
    {
        Stay,
        Wander,
    }

    public void Take(string name, float x, float z, float homeRadius)
    {
        habit = name == "wander" ? Habit.Wander : Habit.Stay;
        home = new Vector2(x, z);
        radius = homeRadius;
        travels = false;
        airborne = false;
        timer = (float)chance.Uniform(0.3, 4.0);
    }

    /// <summary>Calls it to a place.</summary>
    public void GoTo(float x, float z)
    {
        goal = new Vector2(x, z);
        home = goal;
        travels = true;
        called = true;
        timer = 60f;
    }

    public void Push(float x, float z)
    {
        push = new Vector2(x, z);
        pushed = PushSeconds;
    }

    /// <summary>What it does now.</summary>
    public MotionInput Decide(Actor self, float seconds, Stage stage)
    {
        Abilities can = self.Abilities;
        RootPlace place = self.Animator.Root;
        timer -= seconds;
        if (pushed > 0f)
        {
            pushed -= seconds;
            return Shoved(place, can);
        }

        if (timer <= 0f && habit == Habit.Wander)
        {
            Choose(can, stage.Land);
        }

        bool inAir = can.CanFly && (airborne || can.Medium == Medium.Air);
        if (!travels && !inAir && can.Medium != Medium.Water)
        {
            return default;
        }

        Vector2 here = new(place.Position.X, place.Position.Z);
        Vector2 target = travels ? goal : habit == Habit.Wander ? home + (radius * Circle(self)) : home;
        if (travels && Vector2.Distance(here, goal) < 0.8f * can.Length)
        {
            travels = false;
            called = false;
            timer = (float)chance.Uniform(2.5, 7.0);
        }

        bool hovers = !travels && habit == Habit.Stay;
        Vector2 bent = target + Avoid(self, here, stage);
        Vector3 local = place.ToModel(new Vector3(bent.X, place.Position.Y, bent.Y));
        bool far = Vector2.Distance(here, target) > 5f * can.Length;
        float speed = inAir ? can.FlightSpeed : called && far ? can.Run : can.Pace;
        var settings = new SeekSettings(speed, inAir || can.Medium == Medium.Water ? 1.2f : 1.5f, 0f, 0.6f * can.Length, 0.12f, 0.04f, 1.9f);
        BodyVelocity wish = Seek.Decide(ref seek, settings, local);
        float climb = inAir || can.Medium == Medium.Water ? Climb(self, place, stage.Land, inAir) : 0f;
        return hovers && Vector2.Distance(here, home) < can.Length
            ? new MotionInput(0f, 0f, ClimbRate: climb, Medium: inAir ? MotionMedium.Air : MotionMedium.Ground)
            : new MotionInput(wish.Linear.Z, wish.YawRate, ClimbRate: climb, Medium: inAir ? MotionMedium.Air : MotionMedium.Ground);
    }

    private static float Climb(Actor self, RootPlace place, Land land, bool inAir)
    {
        Abilities can = self.Abilities;
        float level = land.HeightAt(place.Position.X, place.Position.Z) + (inAir ? Math.Max(1.6f * can.Length, can.Rise) : can.Rise * (1.2f + (0.5f * (self.Slot % 4))));
        float most = 0.35f * Math.Max(can.Pace, can.FlightSpeed);
        return Math.Clamp(0.8f * (level - place.Position.Y), -most, most);
    }

    /// <summary>A round about its home, for those that cannot stand still.</summary>
    private static Vector2 Circle(Actor self)
    {
        double angle = Math.Atan2(self.Position.X, self.Position.Z) + 0.7;
        return new Vector2((float)Math.Sin(angle), (float)Math.Cos(angle));
    }

    private MotionInput Shoved(RootPlace place, Abilities can)
    {
        Vector3 local = place.ToModel(place.Position + new Vector3(push.X, 0f, push.Y));
        float speed = 2.2f * can.Pace;
        float length = Math.Max((float)Math.Sqrt((local.X * local.X) + (local.Z * local.Z)), 1e-4f);
        return new MotionInput(speed * local.Z / length, 0f, speed * local.X / length, Medium: airborne ? MotionMedium.Air : MotionMedium.Ground);
    }

    private void Choose(Abilities can, Land land)
    {
        if (can.CanFly && can.Medium == Medium.Ground)
        {
            airborne = chance.Chance(0.65);
        }

        travels = chance.Chance(0.75) || airborne;
        double angle = chance.Uniform(0.0, 2.0 * Math.PI);
        double away = radius * Math.Sqrt(chance.Uniform());
        float edge = 0.85f * land.HalfWidth;
        goal = new Vector2(Math.Clamp(home.X + (float)(away * Math.Sin(angle)), -edge, edge), Math.Clamp(home.Y + (float)(away * Math.Cos(angle)), -edge, edge));
        timer = travels ? (float)chance.Uniform(8.0, 16.0) : (float)chance.Uniform(2.0, 6.0);
    }

    /// <summary>How far the way bends round others that are near.</summary>
    private static Vector2 Avoid(Actor self, Vector2 here, Stage stage)
    {
        Vector2 bend = Vector2.Zero;
        foreach (Actor other in stage.Living)
        {
            if (other == self)
            {
                continue;
            }

            Vector2 from = here - new Vector2(other.Position.X, other.Position.Z);
            float apart = from.Length();
            float room = 0.75f * (self.Abilities.Length + other.Abilities.Length);
            if (apart < room && apart > 1e-4f)
            {
                bend += from * (3f * (room - apart) / apart);
            }
        }

        return bend;
    }
}
