namespace FastPoints.Cli.Sources;

/// <summary>Points that sources claim, those that they have, and the difference, except those that a source itself
/// marks as invalid; unknown if any of them is.</summary>
public sealed class PointCounts
{
    ulong m_claimed;
    long m_found, m_invalid;
    bool m_isAny, m_isClaimUnknown, m_isFoundUnknown;

    /// <summary>0 if it is unknown.</summary>
    public ulong Lost { get; private set; }

    public static PointCounts Of(SourceInfo info, long found)
    {
        var counts = new PointCounts();
        counts.Add(info, found);
        return counts;
    }

    /// <param name="found">-1 if they were not counted.</param>
    public void Add(SourceInfo info, long found)
    {
        ulong claimed = info.HasPointsClaimed ? info.PointsClaimed : 0;
        Add(new PointCounts
        {
            m_isAny = true,
            m_isClaimUnknown = !info.HasPointsClaimed,
            m_isFoundUnknown = found < 0,
            m_found = Math.Max(0, found),
            m_claimed = claimed,
            m_invalid = info.PointsMarkedInvalid,
            Lost = found >= 0 && claimed > (ulong)(found + info.PointsMarkedInvalid)
                ? claimed - (ulong)(found + info.PointsMarkedInvalid) : 0,
        });
    }

    public void Add(PointCounts other)
    {
        m_isAny |= other.m_isAny;
        m_isClaimUnknown |= other.m_isClaimUnknown;
        m_isFoundUnknown |= other.m_isFoundUnknown;
        m_found += other.m_found;
        m_invalid += other.m_invalid;
        m_claimed = other.m_claimed > ulong.MaxValue - m_claimed ? ulong.MaxValue : m_claimed + other.m_claimed;
        Lost = other.Lost > ulong.MaxValue - Lost ? ulong.MaxValue : Lost + other.Lost;
    }

    public void WriteKeys(Utf8JsonWriter json)
    {
        Write(json, "pointsClaimed", m_isAny && !m_isClaimUnknown, m_claimed);
        Write(json, "pointsFound", m_isAny && !m_isFoundUnknown, (ulong)m_found);
        Write(json, "pointsLost", m_isAny && !m_isClaimUnknown && !m_isFoundUnknown, Lost);
        json.WriteInteger("pointsMarkedInvalid", m_invalid);
    }

    static void Write(Utf8JsonWriter json, string key, bool isKnown, ulong value)
    {
        if (isKnown)
            json.WriteInteger(key, value);
        else
            json.WriteNull(key);
    }
}
