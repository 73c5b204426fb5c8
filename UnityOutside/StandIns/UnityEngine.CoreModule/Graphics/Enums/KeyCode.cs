namespace UnityEngine;

public enum KeyCode { None = 0, Escape = 27 }
