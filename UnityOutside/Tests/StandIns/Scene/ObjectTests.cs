namespace UnityOutside.Tests.StandIns;

public sealed class ObjectTests
{
    static readonly List<string> s_messages = new List<string>();

    readonly List<string> m_logged = new List<string>();
    GameObject m_object;

    [SetUp]
    public void MakeObject()
    {
        s_messages.Clear();
        m_logged.Clear();
        Debug.s_sink = (type, text) => m_logged.Add(type + ": " + text);
        m_object = new GameObject("object");
    }

    [TearDown]
    public void DestroyObject()
    {
        Object.DestroyImmediate(m_object);
        SceneLoop.IsPlaying = false;
        Debug.s_sink = null;
    }

    [Test]
    public void Layer_OutOfRange_IsLoggedAndUnchanged()
    {
        m_object.layer = 31;
        m_object.layer = 32;
        Assert.That(m_object.layer, Is.EqualTo(31));
        Assert.That(m_logged, Has.Count.EqualTo(1).And.All.Contains("[0...31]"));
    }

    [Test]
    public void Destroyed_Object_EqualsNullAndThrows()
    {
        var reported = m_object.AddComponent<AlwaysExecuted>();
        reported.Kept = 3;
        Object.DestroyImmediate(m_object);
        Assert.That(m_object == null && reported == null && !reported, Is.True);
        Assert.That(ReferenceEquals(reported, null), Is.False);
        Assert.That(reported.Kept, Is.EqualTo(3), "its own");
        Assert.That(() => m_object.name, Throws.TypeOf<MissingReferenceException>());
        Assert.That(() => reported.gameObject, Throws.TypeOf<MissingReferenceException>());
        Assert.That(() => reported.enabled, Throws.TypeOf<MissingReferenceException>());
        Assert.That(() => reported.transform, Throws.TypeOf<MissingReferenceException>());
    }

    [Test]
    public void Destroy_InEditMode_IsRefused()
    {
        Object.Destroy(m_object);
        SceneLoop.Update();
        Assert.That(m_object != null, Is.True);
        Assert.That(m_logged, Has.Count.EqualTo(1).And.Some.Contains("edit mode"));
    }

    [Test]
    public void Destroy_InPlayMode_IsAtTheFramesEnd()
    {
        SceneLoop.IsPlaying = true;
        var child = new GameObject("child");
        child.transform.SetParent(m_object.transform, false);
        Object.Destroy(m_object);
        Assert.That(m_object != null, Is.True);
        SceneLoop.Update();
        Assert.That(m_object == null && child == null, Is.True, "children go with it");
    }

    [Test]
    public void Messages_InEditMode_ReachExecuteAlwaysOnly()
    {
        m_object.AddComponent<Recorder>();
        Assert.That(s_messages, Is.EqualTo(new[] { "Reset" }));
        s_messages.Clear();
        var always = m_object.AddComponent<AlwaysExecuted>();
        SceneLoop.Update();
        always.enabled = false;
        always.enabled = true;
        Object.DestroyImmediate(m_object);
        Assert.That(s_messages, Is.EqualTo(new[]
        {
            "Awake", "OnEnable", "Reset", "Start", "Update", "OnDisable", "OnEnable", "OnDisable", "OnDestroy",
        }));
    }

    [Test]
    public void Messages_InPlayMode_WaitUntilTheObjectIsActive()
    {
        SceneLoop.IsPlaying = true;
        var parent = new GameObject("parent");
        parent.SetActive(false);
        m_object.transform.SetParent(parent.transform, false);
        var reported = m_object.AddComponent<Recorder>();
        SceneLoop.Update();
        Assert.That(s_messages, Is.Empty);
        Assert.That((reported.enabled, reported.isActiveAndEnabled), Is.EqualTo((true, false)));
        parent.SetActive(true);
        Assert.That(s_messages, Is.EqualTo(new[] { "Awake", "OnEnable" }));
        parent.SetActive(false);
        Object.DestroyImmediate(parent);
        Assert.That(s_messages, Is.EqualTo(new[] { "Awake", "OnEnable", "OnDisable", "OnDestroy" }));
    }

    [Test]
    public void Destroyed_BehaviourThatNeverWoke_GetsNoCallback()
    {
        SceneLoop.IsPlaying = true;
        m_object.SetActive(false);
        m_object.AddComponent<Recorder>();
        Object.DestroyImmediate(m_object);
        Assert.That(s_messages, Is.Empty);
    }

    [Test]
    public void AddComponent_DisallowedDuplicate_ReturnsNull()
    {
        m_object.AddComponent<Single>();
        Assert.That(m_object.AddComponent<Single>(), Is.Null);
        Assert.That(m_logged, Has.Count.EqualTo(1));
    }

    [Test]
    public void FindObjectsOfTypeAll_Components_IncludesDisabledOnes()
    {
        m_object.SetActive(false);
        var off = m_object.AddComponent<Recorder>();
        Assert.That(Resources.FindObjectsOfTypeAll<Recorder>(), Is.EqualTo(new[] { off }));
        Object.DestroyImmediate(off);
        Assert.That(Resources.FindObjectsOfTypeAll<Recorder>(), Is.Empty);
    }

    [ExecuteAlways]
    sealed class AlwaysExecuted : MonoBehaviour
    {
        public int Kept;

        void Awake() => s_messages.Add("Awake");
        void OnEnable() => s_messages.Add("OnEnable");
        void Reset() => s_messages.Add("Reset");
        void Start() => s_messages.Add("Start");
        void Update() => s_messages.Add("Update");
        void OnDisable() => s_messages.Add("OnDisable");
        void OnDestroy() => s_messages.Add("OnDestroy");
    }

    sealed class Recorder : MonoBehaviour
    {
        void Awake() => s_messages.Add("Awake");
        void OnEnable() => s_messages.Add("OnEnable");
        void Reset() => s_messages.Add("Reset");
        void OnDisable() => s_messages.Add("OnDisable");
        void OnDestroy() => s_messages.Add("OnDestroy");
    }

    [DisallowMultipleComponent]
    sealed class Single : MonoBehaviour { }
}
